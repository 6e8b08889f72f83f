// SPDX-License-Identifier: BSD-3-Clause
// Results so far: a file for each part, so that nothing is lost with a process.
#ifndef CardResults_h
#define CardResults_h

#include <nlohmann/json.hpp>

#include <string> // for names

namespace card
{
/** {units: {<name>: {status, seconds, ...}}}; without units where the file is not there. */
nlohmann::json LoadPart(const std::string& output, const std::string& part);

/** Replaces the file at once. Throws std::runtime_error when it cannot be written. */
void SavePart(const std::string& output, const std::string& part, const nlohmann::json& values);

/** Returns true if a unit has ended, however it ended, so that it need not be done again. */
bool IsDone(const nlohmann::json& part, const std::string& unit);

/** Replaces a file of text at once. */
void WriteText(const std::string& path, const std::string& text);
}

#endif
