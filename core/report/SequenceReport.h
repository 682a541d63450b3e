#pragma once

#include <string>
#include <vector>

#include "core/evaluation/SequenceEvaluation.h"
#include "core/report/Section.h"

namespace vestige {

struct SequenceReportInput {
    std::string name;  ///< of the folder
    SequenceExtent extent;
    std::vector<SequenceScore> scores;
    std::vector<int> tables;  ///< published tables to show beside, 2 and 3
    std::string date;         ///< ISO 8601
    int threads = 1;
    std::string processor;
    std::string filterRadius;  ///< as people read it; shown where a filter was used
    std::string preset;        ///< of improved NDT
};

/// The comparison of registration methods on a sequence: what the sequence is, each published table beside
/// its counterpart, the charts, every combination.
Report sequenceReport(const SequenceReportInput& input);

/// A published table's counterpart in words, for people: at how many sizes improved NDT is lower than classic
/// NDT (table 2), which filter is lowest at each size (table 3). Empty where the runs are not there.
std::string conclusionOf(int table, const std::vector<SequenceScore>& scores);

}  // namespace vestige
