// Three numbers in a register of four: the fourth is 0 wherever a dot product is taken, and pads
// arrays to whole registers. Vector instructions come with the compiler's vector type; without AVX
// it is two registers of two. No operation is fused or reordered by the instruction set: results
// are the same on every machine.
#pragma once

// No register is passed through a call: what takes or gives one is inlined, or takes a reference.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace slidewave::dem {

using Vec4 = double __attribute__((vector_size(32)));

#define SLIDEWAVE_INLINE __attribute__((always_inline)) inline

SLIDEWAVE_INLINE double dot(Vec4 const& a, Vec4 const& b) {
  Vec4 const product = a * b;
  return (product[0] + product[2]) + (product[1] + product[3]);
}

SLIDEWAVE_INLINE Vec4 cross(Vec4 const& a, Vec4 const& b) {
  Vec4 const turned =
      a * __builtin_shufflevector(b, b, 1, 2, 0, 3) - __builtin_shufflevector(a, a, 1, 2, 0, 3) * b;
  return __builtin_shufflevector(turned, turned, 1, 2, 0, 3);
}

/// The same with the fourth number 0.
SLIDEWAVE_INLINE Vec4 three(Vec4 const& a) {
  return __builtin_shufflevector(a, Vec4{0, 0, 0, 0}, 0, 1, 2, 7);
}

SLIDEWAVE_INLINE Vec4 load3(double const* x) {
  return Vec4{x[0], x[1], x[2], 0};
}

SLIDEWAVE_INLINE void store3(Vec4 const& a, double* x) {
  for (int k = 0; k < 3; ++k) {
    x[k] = a[k];
  }
}

}  // namespace slidewave::dem
