// Whether the processor at hand has what x86-64-v3 asks for. No library of a compiler is needed: not all have the table
// behind __builtin_cpu_supports.
#pragma once

#if defined(__x86_64__)
#include <cpuid.h>
#endif

namespace nonhertz {

inline bool knows_v3() {
#if defined(__x86_64__)
  unsigned a = 0, b = 0, c = 0, d = 0, b7 = 0;
  if (!__get_cpuid_count(7, 0, &a, &b7, &c, &d) || !__get_cpuid(1, &a, &b, &c, &d)) return false;
  const unsigned fma_movbe_osxsave_avx_f16c = 1u << 12 | 1u << 22 | 1u << 27 | 1u << 28 | 1u << 29;
  if ((c & fma_movbe_osxsave_avx_f16c) != fma_movbe_osxsave_avx_f16c) return false;
  const unsigned bmi1_avx2_bmi2 = 1u << 3 | 1u << 5 | 1u << 8;
  if ((b7 & bmi1_avx2_bmi2) != bmi1_avx2_bmi2) return false;
  const unsigned lzcnt = 1u << 5;
  if (!__get_cpuid(0x80000001, &a, &b, &c, &d) || (c & lzcnt) != lzcnt) return false;
  unsigned low = 0, high = 0;  // what the operating system keeps of the registers when it switches tasks
  __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return (low & 6) == 6;
#else
  return false;
#endif
}

}  // namespace nonhertz
