// Numbers by which LIGGGHTS knows our contact models: below 64, unlike any of the packaged ones.
#pragma once

namespace slidewave::dem {

constexpr int linear_id = 40;
constexpr int coulomb_id = 40;
constexpr int jiang_id = 40;
constexpr int iwashita_oda_id = 41;

}  // namespace slidewave::dem
