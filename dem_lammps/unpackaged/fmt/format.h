// LAMMPS' headers include this one, which Debian does not package, and the fmt library's of the
// same name is another version. What their templates mention is declared here; we use none of it:
// messages go to Error as plain std::string.
#pragma once

namespace fmt {

class string_view;
class format_args;

template <typename... Args, typename Format, typename... Given>
format_args make_args_checked(Format const&, Given const&...);

}  // namespace fmt
