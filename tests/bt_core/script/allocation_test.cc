// Running a script allocates nothing.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "bt_core/data/standard_types.h"
#include "tests/bt_core/counting_new.h"
#include "tests/bt_core/script/fixture.h"

namespace coppice {
namespace {

// Allocations of 100 runs after the first.
std::size_t AllocationsOf(ScriptBench& bench, std::string_view text) {
  const Script script = bench.Compile(text);
  bool value = script.Test(bench.blackboard());
  const std::size_t before = Allocations();
  for (int i = 0; i < 100; ++i) {
    script.Run(bench.blackboard());
    value = script.Test(bench.blackboard()) || value;
  }
  return Allocations() - before;
}

TEST(ScriptAllocations, AreCounted) {
  ScriptBench bench;
  bench.Set("s", std::string(2000, 'x'));
  EXPECT_GT(AllocationsOf(bench, "(s .. s) == 'a'"), 100U) << "a long text is made in every run";
}

TEST(ScriptAllocations, ARunMakesNone) {
  ScriptBench bench;
  bench.Declare<Status>("status");
  bench.Set("status", Status::kSuccess);
  bench.Set("d", 20.5);
  bench.Set("i", std::int64_t{3});
  bench.Set("b", true);
  bench.Set("s", std::string(200, 's'));
  bench.Set("t", std::string(200, 't'));
  for (const char* text :
       {"d > 20 && !b", "i += 1; i % 7 == 3 || d / i > 2", "copy := s; copy == s",
        "s != t && s < t", "x := i < 3 ? 1 : 2.5", "flag := !b; flag = flag || b",
        "name := 'box_' .. i .. '_' .. d; 1", "status = 2; status == 3",
        "min(i, d, 7) < clamp(i, 0, 9)", "copy := (copy := t) .. ''; true",
        "long_one := 'a text that is longer than fifteen'; 0"}) {
    EXPECT_EQ(AllocationsOf(bench, text), 0U) << text;
  }
}

}  // namespace
}  // namespace coppice
