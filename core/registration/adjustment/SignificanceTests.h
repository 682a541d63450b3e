#pragma once

namespace vestige {

/// Probability that a chi-square variable of `degrees` (even, at least 2) exceeds x: a finite sum.
double chiSquareTail(double x, int degrees);
/// The x that such a variable exceeds with this probability.
double chiSquareLimit(double probability, int degrees);
/// Probability that Fisher's F of (numerator, denominator) degrees of freedom, both even, exceeds x: a finite
/// sum (incomplete beta function of whole arguments).
double fisherTail(double x, int numerator, int denominator);

}  // namespace vestige
