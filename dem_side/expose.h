// Legal access to what LIGGGHTS keeps private: explicit instantiation ignores access control.
//
//   struct FixMapTag { using type = Map* Modify::*; friend type get(FixMapTag); };
//   template struct Expose<FixMapTag, &Modify::fix_map>;
//   lmp->modify->*get(FixMapTag{})
//
// The tag must be in this namespace itself, not in an unnamed one, for get() to be found.
#pragma once

namespace slidewave::dem {

template <class Tag, typename Tag::type member>
struct Expose {
  friend typename Tag::type get(Tag) { return member; }
};

}  // namespace slidewave::dem
