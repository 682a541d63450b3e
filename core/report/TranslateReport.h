#pragma once

#include "core/base/Language.h"
#include "core/report/Section.h"

namespace vestige {

/// The report in another language: titles, sentences, tables, captions and charts. What people named
/// (Report::names) and what files for machines have, too (numbers, hashes) stays. English: as it is.
Report translated(Report report, Language language);

}  // namespace vestige
