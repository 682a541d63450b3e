#pragma once

#include "ui/actions/ActionSpec.h"

namespace vestige {

class Attempts;
class Comparison;
class Document;
class JobRunner;
class PointSelection;
class Preview;
class Selection;

/// What is the case now, for the rules that enable actions.
Situation situationOf(const Document& document, const Selection& selection, const JobRunner& jobs,
                      const Attempts& attempts, const Preview& preview, const Comparison& comparison,
                      const PointSelection* points = nullptr);

}  // namespace vestige
