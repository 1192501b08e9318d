// slidewave_dem --script FILE [-var NAME VALUE ...]: an ordinary LIGGGHTS run, no partner, with our
// own styles available. For preparing scenes.
#pragma once

namespace slidewave::dem {

/// Takes main()'s arguments; gives the exit status. LIGGGHTS leaves by itself with 1 on an error.
int run_script(int argument_count, char** arguments);

}  // namespace slidewave::dem
