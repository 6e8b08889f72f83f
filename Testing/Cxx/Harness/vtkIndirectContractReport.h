// SPDX-License-Identifier: BSD-3-Clause
// Reads the report of vtkIndirectIlluminationPass by JSON's strict grammar (RFC 8259), in any
// locale.
#ifndef vtkIndirectContractReport_h
#define vtkIndirectContractReport_h

#include <map>
#include <string>

class vtkIndirectIlluminationPass;

namespace contract
{
class Report
{
public:
  /** Report of the pass's last frame; fails the test if it is invalid or lacks a key of its
   * schema. */
  explicit Report(vtkIndirectIlluminationPass* pass);
  explicit Report(const std::string& text);

  bool IsValid() const { return this->Valid; }
  const std::string& GetText() const { return this->Text; }
  bool Has(const std::string& path) const { return this->Values.count(path) > 0; }
  /**
   * A number, word or string (decoded) by its path, e.g. `settings.Caching` or `left_out.0.what`;
   * for a list or object the number of its members. Empty if there is none.
   */
  std::string Get(const std::string& path) const;
  /** The value as a number; NaN if it is none. */
  double GetNumber(const std::string& path) const;
  /**
   * The reason for an item of a list (`modelled`, `left_out`) by its name, which may be followed by
   * the names of props in parentheses; empty if the list lacks it.
   */
  std::string FindReason(const std::string& list, const std::string& what) const;

private:
  std::string Text;
  bool Valid = false;
  std::map<std::string, std::string> Values;
};

/** A counter of the pass's report. */
long long CountOf(vtkIndirectIlluminationPass* pass, const std::string& counter);
}

#endif
