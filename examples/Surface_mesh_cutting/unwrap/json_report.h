#ifndef UNWRAP_JSON_REPORT_H
#define UNWRAP_JSON_REPORT_H

#include "outcome.h"

#include <string>

// The name of an exit code in the report.
const char* name_of(Exit_code code);

// By this a file is known to be a report.
constexpr const char* start_of_report = "{\n  \"status\": \"";

// One JSON object. Its keys are always the same; null is what was not computed.
std::string to_json(const Outcome& outcome);

#endif // UNWRAP_JSON_REPORT_H
