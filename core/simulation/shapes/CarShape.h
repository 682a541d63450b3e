#pragma once

#include "core/base/ParameterSet.h"
#include "core/simulation/Material.h"

namespace vestige {

/// The lines that a car is drawn from: side view, plan view and section. Metres; x forward, y to the left, z
/// up, the origin on the ground under the middle. Width is the body's, without mirrors.
struct CarShape {
    explicit CarShape(const ParameterSet& parameters);

    double halfLength;
    double halfWidth;
    double height;
    double wheelRadius;
    double archRadius;
    double axle;  ///< front axle at +axle, rear axle at -axle
    double mirrorWidth;
    double handleLength;
    Material paint;

    double cowl;         ///< x where the windscreen begins
    double roofFront;    ///< x where the roof begins
    double roofRear;     ///< x where the roof ends
    double rearBase;     ///< x where the rear window ends
    double mirrorX;      ///< x of the mirrors' rims
    double handleX;      ///< x of the front door handles' middle
    double mirrorZ;      ///< height of the mirrors' middle
    double handleZ;      ///< height of the handles
    double mirrorInner;  ///< distance of a mirror's inner end from the car's middle plane

    /// Height of bonnet, belt line and boot at x.
    double deckHeight(double x) const;
    /// Lower edge of the side at x: the sill, or the wheel arch.
    double lowerEdge(double x) const;
    /// Half width at height z as a share of halfWidth: exactly 1 from 0.55 m to 0.78 m.
    double widthShare(double z) const;
    /// How far the front (or rear) end stands back at height z: exactly 0 from 0.42 m to 0.58 m.
    double endRecess(double z) const;
    /// Plan view: half width share at the length share u in -1..1, exactly 1 for |u| <= 0.5, and its inverse.
    static double planWidth(double u);
    static double planLength(double v);
    static constexpr double kStraightTo = 0.5;

    double beltWidth() const { return 0.90 * halfWidth; }
    double railWidth() const { return 0.68 * halfWidth; }
    /// Height of the roof's rails at share s of its length, front to rear.
    double railHeight(double s) const;
};

}  // namespace vestige
