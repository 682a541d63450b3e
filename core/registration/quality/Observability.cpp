#include "core/registration/quality/Observability.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <cmath>

#include "core/registration/quality/DirectionWords.h"

namespace vestige {
namespace {

using Basis = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// Orthonormal columns of the same span: first those that turn least, among them those that rise least.
Basis untangled(const Basis& free) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> turns(free.bottomRows<3>(), Eigen::ComputeFullV);
    // Largest turn first: backwards.
    Basis basis = free * turns.matrixV().rowwise().reverse();
    constexpr double kNoTurn = 0.1;
    Eigen::Index shifts = 0;
    while (shifts < basis.cols() && basis.col(shifts).tail<3>().norm() < kNoTurn) ++shifts;
    if (shifts < 2) return basis;
    const Eigen::MatrixXd rise = basis.row(2).head(shifts);
    const Eigen::JacobiSVD<Eigen::MatrixXd> rises(rise, Eigen::ComputeFullV);
    basis.leftCols(shifts) = (basis.leftCols(shifts) * rises.matrixV().rowwise().reverse()).eval();
    return basis;
}

/// The sign is free: the largest component is positive, so that texts and arrows stay put.
Vector6d signedUp(const Vector6d& vector) {
    Eigen::Index largest = 0;
    vector.cwiseAbs().maxCoeff(&largest);
    return vector[largest] < 0 ? Vector6d(-vector) : vector;
}

}  // namespace

std::vector<ObservedDirection> observedDirections(const PoseInformation& information,
                                                  const Matrix6d& covariance, double freeSigma_m) {
    const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(information.hessian);
    const auto sigmaOf = [&](const Vector6d& v) { return std::sqrt(std::max(0.0, v.dot(covariance * v))); };
    // The covariance knows more than the Hessian: any of the six may be free, those come first.
    Matrix6d vectors;
    Eigen::Index free = 0;
    const auto isFree = [&](Eigen::Index i) {
        const Vector6d v = solver.eigenvectors().col(i);
        return !(sigmaOf(v) <= freeSigma_m && information.holds(v));
    };
    for (Eigen::Index i = 0; i < 6; ++i)
        if (isFree(i)) vectors.col(free++) = solver.eigenvectors().col(i);
    for (Eigen::Index i = 0, held = free; i < 6; ++i)
        if (!isFree(i)) vectors.col(held++) = solver.eigenvectors().col(i);
    if (free > 0) vectors.leftCols(free) = untangled(vectors.leftCols(free));
    std::vector<ObservedDirection> directions(6);
    for (Eigen::Index i = 0; i < 6; ++i) {
        ObservedDirection& one = directions[static_cast<std::size_t>(i)];
        one.direction = signedUp(vectors.col(i));
        one.information = std::max(0.0, one.direction.dot(information.hessian * one.direction));
        one.sigma_m = sigmaOf(one.direction);
        one.free = i < free;
        one.words = motionWords(one.direction);
    }
    return directions;
}

}  // namespace vestige
