// SPDX-License-Identifier: BSD-3-Clause
// What the report says, and that it is what was in force.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkRadianceHintsPass.h"

using namespace contract;

//------------------------------------------------------------------------------
// The tests' own reader takes JSON and nothing else.
CONTRACT_TEST(ReportReader)
{
  for (const char* good : { "{}", "[]", "{\"a\": [1, -0.5e-7, 0], \"b\": null}", " true ",
         "\"\\u001f\\n\"", "\"\xc3\xa4\"" })
  {
    CONTRACT_CHECK(Report(std::string(good)).IsValid(), good);
  }
  for (const char* bad :
    { "", "{", "{\"a\": 0,5}", "{\"a\": 1.}", "{\"a\": .5}", "01", "+1", "nan", "1.024.000",
      "\"\n\"", "\"\\x\"", "\"\xe4\"", "\"\xc0\xaf\"", "{\"a\": 1, \"a\": 2}", "[1,]", "{} {}" })
  {
    CONTRACT_CHECK(!Report(std::string(bad)).IsValid(), bad);
  }
  const Report report(std::string("{\"a\": {\"b\": [1, 2.5]}, \"c\": \"\\\"x\\u0001\"}"));
  CONTRACT_CHECK(report.GetNumber("a.b.1") == 2.5, report.Get("a.b.1"));
  CONTRACT_CHECK(report.Get("c") == "\"x\1", report.Get("c"));
  CONTRACT_CHECK(std::isnan(report.GetNumber("c")), "a text is no number");
}

//------------------------------------------------------------------------------
// A grid has as many hints as its property says, which never says more than there can be.
CONTRACT_TEST(ReportGrid)
{
  View view(60, 40);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  vtkNew<vtkRadianceHintsPass> hints;
  pass->SetEstimator(hints);
  view.Renderer->SetPass(pass);
  struct Row
  {
    int Set[3];
    int Expected[3];
  };
  for (const Row& row :
    { Row{ { 5000, 5000, 5000 }, { 64, 64, 64 } }, Row{ { -3, 1, 1 }, { 0, 1, 1 } },
      Row{ { 64, 2, -1 }, { 64, 2, 0 } }, Row{ { 3, 4, 5 }, { 3, 4, 5 } } })
  {
    hints->SetGridResolution(row.Set[0], row.Set[1], row.Set[2]);
    const int* found = hints->GetGridResolution();
    CONTRACT_CHECK(std::equal(found, found + 3, row.Expected),
      row.Set[0] << ": " << found[0] << " " << found[1] << " " << found[2]);
  }
  const vtkMTimeType before = hints->GetMTime();
  hints->SetGridResolution(hints->GetGridResolution());
  CONTRACT_CHECK(hints->GetMTime() == before, "nothing has changed");
  view.Grab();
  CONTRACT_CHECK(hints->GetNumberOfHints() == 60, hints->GetNumberOfHints() << " hints");
  const std::string grid = Report(pass).FindReason("modelled", "1 diffuse bounce");
  CONTRACT_CHECK(grid.find("3 x 4 x 5") != std::string::npos, grid);
}
