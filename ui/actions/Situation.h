#pragma once

#include "ui/actions/ActionSpec.h"

namespace vestige {

class Document;
class JobRunner;
class Selection;

/// What is the case now, for the rules that enable actions.
Situation situationOf(const Document& document, const Selection& selection, const JobRunner& jobs);

}  // namespace vestige
