// The results of a study of methods, as a chart and as a table.
#pragma once

#include "charts/work_precision.h"
#include "study/study.h"

#include <string>

namespace charts {

// `name` of the scene, for the title. Without rows the axes alone.
[[nodiscard]] WorkPrecision chartOf(const std::string& name, const simulation::StudyPlan& plan,
                                    const simulation::StudyResult& result);

// Comma-separated values: a line of names, then one for each row. Numbers read back as they were.
[[nodiscard]] std::string tableOf(const simulation::StudyResult& result);

} // namespace charts
