#include "bt_core/engine/compile/compiler_problems.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

TEST(Problems, TheSameProblemInTheSamePlaceIsReportedOnce) {
  Diagnostics diagnostics;
  const Document document = *Document::FromText("<root/>", "t.xml", diagnostics);
  Problems problems(diagnostics);
  for (int i = 0; i < 2; ++i) {
    problems.Error(document, 0, "wrong", "hint");
    problems.Warning(document, 1, "odd");
    problems.Error(document, 1, "wrong");
  }
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:1:1: error: wrong (hint)\nt.xml:1:2: warning: odd\nt.xml:1:2: error: wrong\n");
  EXPECT_TRUE(problems.has_errors());
}

TEST(Problems, TheSameProblemInTwoFilesIsReportedTwice) {
  Diagnostics diagnostics;
  const Document a = *Document::FromText("<root/>", "a.xml", diagnostics);
  const Document b = *Document::FromText("<root/>", "b.xml", diagnostics);
  Problems problems(diagnostics);
  problems.Warning(a, 0, "odd");
  problems.Warning(b, 0, "odd");
  EXPECT_EQ(diagnostics.all().size(), 2U);
  EXPECT_FALSE(problems.has_errors());
}

}  // namespace
}  // namespace coppice
