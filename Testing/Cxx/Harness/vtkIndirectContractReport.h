// SPDX-License-Identifier: BSD-3-Clause
// Reads the report of vtkIndirectIlluminationPass as strictly as JSON's grammar (RFC 8259) demands,
// in any locale.
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
  /** Of the pass's last frame; fails the test when it is not valid or a key of its schema lacks. */
  explicit Report(vtkIndirectIlluminationPass* pass);
  explicit Report(const std::string& text);

  bool IsValid() const { return this->Valid; }
  const std::string& GetText() const { return this->Text; }
  bool Has(const std::string& path) const { return this->Values.count(path) > 0; }
  /**
   * A number, word or string (decoded) by its place, e.g. `settings.Caching` or `left_out.0.what`;
   * of a list or object the number of its members. Empty when there is none.
   */
  std::string Get(const std::string& path) const;
  /** The same as a number; NaN when it is none. */
  double GetNumber(const std::string& path) const;
  /**
   * The reason of what a list (`modelled`, `left_out`) has under a name, maybe with which props
   * these are after it in parentheses; empty when it is not there.
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
