// SPDX-License-Identifier: BSD-3-Clause
// Keys of kept results: which inputs make them differ, and what the difference is called.
#include "vtkIndirectTestUtilities.h"

#include "OpenGL/vtkIndirectKey.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <limits>

using namespace vtkIndirectTest;

namespace
{
std::string Join(const std::vector<std::string>& names)
{
  std::string joined;
  for (const std::string& name : names)
  {
    joined += (joined.empty() ? "" : ", ") + name;
  }
  return joined;
}

vtkIndirectKey MakeKey(double eye, int size, vtkObject* sampler)
{
  vtkIndirectKey key;
  key.Add("eye", eye).Add("size", size).Add("sampler", sampler);
  return key;
}
}

VTK_INDIRECT_TEST(KeyIsEqualBitByBit)
{
  vtkNew<vtkObject> sampler;
  const vtkIndirectKey key = MakeKey(1.0, 7, sampler);
  Check("the same inputs", key == MakeKey(1.0, 7, sampler));
  Check("a number that differs in the last bit",
    key != MakeKey(1.0 + std::numeric_limits<double>::epsilon(), 7, sampler));
  Check("both zeros are one number", MakeKey(0.0, 7, sampler) == MakeKey(-0.0, 7, sampler));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Check("no number is itself", MakeKey(nan, 7, sampler) == MakeKey(nan, 7, sampler));
  Check("no object is not an object", key != MakeKey(1.0, 7, nullptr));
  sampler->Modified();
  Check("an object that has been modified", key != MakeKey(1.0, 7, sampler));
  Check("a key of no inputs is empty", vtkIndirectKey().IsEmpty());
  // A double holds no more than 53 bits of a time.
  vtkIndirectKey large;
  vtkIndirectKey larger;
  large.Add("time", vtkTypeUInt64(1) << 60);
  larger.Add("time", (vtkTypeUInt64(1) << 60) + 1);
  Check("large times that differ by one", large != larger);
  Check("a key takes another", large.Take(larger));
  Check("and then equals it", large == larger && !large.Take(larger));
  Check("a new key takes that of no object", vtkIndirectKey().Take({ "sampler", nullptr }));
}

VTK_INDIRECT_TEST(KeyNamesWhatChanged)
{
  const vtkIndirectKey key = MakeKey(1.0, 7, nullptr);
  Check("nothing", Join(key.FindChanges(key)) == "");
  Check("the eye", Join(MakeKey(2.0, 7, nullptr).FindChanges(key)) == "eye");
  Check("only the eye", MakeKey(2.0, 7, nullptr).DiffersOnlyIn({ "pace", "eye" }, key));
  Check("not only the eye", !MakeKey(2.0, 8, nullptr).DiffersOnlyIn({ "pace", "eye" }, key));
  Check("the eye and the size", Join(MakeKey(2.0, 8, nullptr).FindChanges(key)) == "eye, size");
  vtkIndirectKey longer = key;
  longer.Add("lights", 1.0).Add("eye", 3.0);
  Check("inputs that came", Join(longer.FindChanges(key)) == "eye, lights");
  Check("inputs that went", Join(key.FindChanges(longer)) == "eye, lights");
  Check("all inputs of the first", Join(key.FindChanges({})) == "eye, size, sampler");
}
