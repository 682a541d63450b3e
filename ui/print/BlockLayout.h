#pragma once

#include "core/report/Section.h"
#include "ui/print/PageFlow.h"

namespace vestige {

/// Title, subtitle and what the report is about, at the head of the first page.
void layoutTitle(PageFlow& flow, const Report& report);
/// A section's heading (kept with what follows) and its blocks. Throws ErrorException when a picture cannot
/// be read.
void layoutSection(PageFlow& flow, const Section& section, int number);
/// A table (TableLayout.cpp): rows stay whole, the head is repeated on every page.
void layoutTable(PageFlow& flow, const Table& table);

}  // namespace vestige
