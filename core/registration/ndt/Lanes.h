#pragma once

// Eight floats at a time, for the .cpp files of the kernels alone
// (docs/decisions/0007-ndt-kernel-and-schedule.md).
#include <immintrin.h>

namespace vestige {

struct Lanes {
    __m256 v;

    static Lanes of(float x) { return {_mm256_set1_ps(x)}; }
    static Lanes zero() { return {_mm256_setzero_ps()}; }
    static Lanes load(const float* from) { return {_mm256_loadu_ps(from)}; }
    void store(float* to) const { _mm256_storeu_ps(to, v); }

    friend Lanes operator+(Lanes a, Lanes b) { return {_mm256_add_ps(a.v, b.v)}; }
    friend Lanes operator-(Lanes a, Lanes b) { return {_mm256_sub_ps(a.v, b.v)}; }
    friend Lanes operator*(Lanes a, Lanes b) { return {_mm256_mul_ps(a.v, b.v)}; }
    friend Lanes operator/(Lanes a, Lanes b) { return {_mm256_div_ps(a.v, b.v)}; }
    friend Lanes operator-(Lanes a) { return {_mm256_xor_ps(a.v, _mm256_set1_ps(-0.0F))}; }
};

/// a b + c with one rounding.
inline Lanes fma(Lanes a, Lanes b, Lanes c) {
    return {_mm256_fmadd_ps(a.v, b.v, c.v)};
}
/// a b - c with one rounding.
inline Lanes fms(Lanes a, Lanes b, Lanes c) {
    return {_mm256_fmsub_ps(a.v, b.v, c.v)};
}
/// c - a b with one rounding.
inline Lanes fnma(Lanes a, Lanes b, Lanes c) {
    return {_mm256_fnmadd_ps(a.v, b.v, c.v)};
}
inline Lanes min(Lanes a, Lanes b) {
    return {_mm256_min_ps(a.v, b.v)};
}
inline Lanes max(Lanes a, Lanes b) {
    return {_mm256_max_ps(a.v, b.v)};
}
inline Lanes sqrt(Lanes a) {
    return {_mm256_sqrt_ps(a.v)};
}
inline Lanes abs(Lanes a) {
    return {_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.v)};
}
/// The magnitude of `a` with the sign of `sign`.
inline Lanes withSign(Lanes a, Lanes sign) {
    const __m256 bit = _mm256_set1_ps(-0.0F);
    return {_mm256_or_ps(_mm256_andnot_ps(bit, a.v), _mm256_and_ps(bit, sign.v))};
}
/// All bits set where a < b.
inline Lanes below(Lanes a, Lanes b) {
    return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)};
}
inline Lanes select(Lanes mask, Lanes yes, Lanes no) {
    return {_mm256_blendv_ps(no.v, yes.v, mask.v)};
}

/// e^x for x <= 0 to 2e-7 relative, 0 below -40: the same bits on every processor. (Range reduction by powers
/// of two, Taylor's series of the rest.)
inline Lanes exponential(Lanes x) {
    const Lanes power = {_mm256_round_ps((x * Lanes::of(1.44269504F)).v, _MM_FROUND_TO_NEAREST_INT)};
    Lanes r = fnma(power, Lanes::of(0.693359375F), x);
    r = fnma(power, Lanes::of(-2.12194440e-4F), r);
    Lanes sum = Lanes::of(1.0F / 720);
    for (const float c : {1.0F / 120, 1.0F / 24, 1.0F / 6, 0.5F, 1.0F, 1.0F}) sum = fma(sum, r, Lanes::of(c));
    const __m256i exponent =
        _mm256_slli_epi32(_mm256_add_epi32(_mm256_cvtps_epi32(power.v), _mm256_set1_epi32(127)), 23);
    const Lanes scaled = sum * Lanes{_mm256_castsi256_ps(exponent)};
    return select(below(x, Lanes::of(-40)), Lanes::zero(), scaled);
}

/// Rows become columns.
inline void transpose(Lanes (&rows)[8]) {
    __m256 a[8], b[8];
    for (int i = 0; i < 4; ++i) {
        a[2 * i] = _mm256_unpacklo_ps(rows[2 * i].v, rows[2 * i + 1].v);
        a[2 * i + 1] = _mm256_unpackhi_ps(rows[2 * i].v, rows[2 * i + 1].v);
    }
    for (int half = 0; half < 2; ++half) {
        const int k = 4 * half;
        b[k] = _mm256_shuffle_ps(a[k], a[k + 2], 0x44);
        b[k + 1] = _mm256_shuffle_ps(a[k], a[k + 2], 0xee);
        b[k + 2] = _mm256_shuffle_ps(a[k + 1], a[k + 3], 0x44);
        b[k + 3] = _mm256_shuffle_ps(a[k + 1], a[k + 3], 0xee);
    }
    for (int i = 0; i < 4; ++i) {
        rows[i].v = _mm256_permute2f128_ps(b[i], b[i + 4], 0x20);
        rows[i + 4].v = _mm256_permute2f128_ps(b[i], b[i + 4], 0x31);
    }
}

/// Eight integers.
struct IntLanes {
    __m256i v;
    static IntLanes of(int x) { return {_mm256_set1_epi32(x)}; }
    friend IntLanes operator+(IntLanes a, IntLanes b) { return {_mm256_add_epi32(a.v, b.v)}; }
    friend IntLanes operator*(IntLanes a, IntLanes b) { return {_mm256_mullo_epi32(a.v, b.v)}; }
    friend IntLanes operator^(IntLanes a, IntLanes b) { return {_mm256_xor_si256(a.v, b.v)}; }
    friend IntLanes operator|(IntLanes a, IntLanes b) { return {_mm256_or_si256(a.v, b.v)}; }
    friend IntLanes operator&(IntLanes a, IntLanes b) { return {_mm256_and_si256(a.v, b.v)}; }
    IntLanes left(int bits) const { return {_mm256_slli_epi32(v, bits)}; }
    IntLanes right(int bits) const { return {_mm256_srli_epi32(v, bits)}; }
};
inline IntLanes floorOf(Lanes x) {
    return {_mm256_cvttps_epi32(_mm256_floor_ps(x.v))};
}

}  // namespace vestige
