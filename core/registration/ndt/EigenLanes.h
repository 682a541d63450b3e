#pragma once

#include <utility>

#include "core/registration/ndt/Lanes.h"

namespace vestige {

/// Eigenvalues (ascending) and unit eigenvectors of eight symmetric 3x3 matrices at once.
struct EigenLanes {
    Lanes values[3];
    Lanes vectors[3][3];  ///< [which][axis]
};

/// Cyclic Jacobi rotations (Golub, Van Loan 2013, section 8.5): five sweeps reach float precision, and it
/// needs nothing but products, quotients and roots, so the bits are the same on every processor.
inline EigenLanes eigenOf(Lanes xx, Lanes xy, Lanes xz, Lanes yy, Lanes yz, Lanes zz) {
    const Lanes zero = Lanes::zero(), one = Lanes::of(1);
    Lanes a[3][3] = {{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
    EigenLanes result{{zero, zero, zero}, {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
    auto& v = result.vectors;
    constexpr int kPairs[3][3] = {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}};
    for (int sweep = 0; sweep < 5; ++sweep)
        for (const auto& [p, q, r] : kPairs) {
            // The tangent of the smaller angle that clears a[p][q]; 0 where it is clear.
            const Lanes twice = Lanes::of(2) * a[p][q];
            const Lanes gap = a[q][q] - a[p][p];
            const Lanes root = abs(gap) + sqrt(fma(gap, gap, twice * twice));
            const Lanes full = withSign(twice, twice * withSign(one, gap)) / root;
            const Lanes t = select(below(zero, root), full, zero);
            const Lanes c = one / sqrt(fma(t, t, one));
            const Lanes s = t * c;
            a[p][p] = fnma(t, a[p][q], a[p][p]);
            a[q][q] = fma(t, a[p][q], a[q][q]);
            a[p][q] = a[q][p] = zero;
            const Lanes pr = a[p][r], qr = a[q][r];
            a[p][r] = a[r][p] = fms(c, pr, s * qr);
            a[q][r] = a[r][q] = fma(s, pr, c * qr);
            for (int axis = 0; axis < 3; ++axis) {
                const Lanes vp = v[p][axis], vq = v[q][axis];
                v[p][axis] = fms(c, vp, s * vq);
                v[q][axis] = fma(s, vp, c * vq);
            }
        }
    for (int i = 0; i < 3; ++i) result.values[i] = a[i][i];
    for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {0, 1}}) {
        const Lanes swap = below(result.values[j], result.values[i]);
        const Lanes low = select(swap, result.values[j], result.values[i]);
        result.values[j] = select(swap, result.values[i], result.values[j]);
        result.values[i] = low;
        for (int axis = 0; axis < 3; ++axis) {
            const Lanes first = select(swap, v[j][axis], v[i][axis]);
            v[j][axis] = select(swap, v[i][axis], v[j][axis]);
            v[i][axis] = first;
        }
    }
    return result;
}

}  // namespace vestige
