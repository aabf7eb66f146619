// The shipped trees run by chance, as their files of scenarios say: every node of a file is
// reached, and returns SUCCESS and FAILURE wherever it can at all. What a file includes has a file
// of its own, where it is looked at with all that it may be given.
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>

#include "bt_core/model/project.h"
#include "bt_core/testing/random_runs.h"
#include "tests/support/folders.h"

namespace coppice {
namespace {

constexpr int kRuns = 300;

struct Can {
  bool succeed = true;
  bool fail = true;
};

std::string TextOf(const Program& program, NodeIndex node, const char* attribute) {
  return std::string(program.TagOf(node).Value(attribute));
}

bool EndsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// What a node with one child can return.
Can DecoratorCan(const Program& program, NodeIndex node, const Can& child) {
  const std::string id = program.Id(node);
  if (id == "Inverter") return {child.fail, child.succeed};
  if (id == "ForceSuccess") return {true, false};
  if (id == "ForceFailure") return {false, true};
  if (id == "KeepRunningUntilFailure") return {false, child.fail};
  if (id == "Timeout") return {child.succeed, true};
  const bool for_ever = TextOf(program, node, "num_attempts") == "-1";
  if (id == "RetryUntilSuccessful") return {child.succeed, child.fail && !for_ever};
  return child;
}

// What a node can return if its leaves can return anything.
Can WhatItCan(const Program& program, NodeIndex node) {
  const std::string id = program.Id(node);
  const NodeIndex end = program.nodes[node].end;
  if (node + 1 == end) return {id != "AlwaysFailure", id != "AlwaysSuccess" && id != "Script"};
  std::vector<Can> children;
  for (NodeIndex child = node + 1; child < end; child = program.nodes[child].end) {
    children.push_back(WhatItCan(program, child));
  }
  if (children.size() == 1) return DecoratorCan(program, node, children[0]);
  if (id == "IfThenElse") children.erase(children.begin());  // the condition
  Can all{true, true};
  Can any{false, false};
  for (const Can& child : children) {
    all = {all.succeed && child.succeed, all.fail && child.fail};
    any = {any.succeed || child.succeed, any.fail || child.fail};
  }
  if (EndsWith(id, "Sequence")) return {all.succeed, any.fail};
  if (EndsWith(id, "Fallback")) return {any.succeed, all.fail};
  if (id.rfind("Switch", 0) == 0 || id == "IfThenElse" || id == "Parallel")
    return any;  // a Parallel of the first to end
  ADD_FAILURE() << "what can a " << id << " return?";
  return {};
}

struct TreeFile {
  std::filesystem::path path;
};
void PrintTo(const TreeFile& file, std::ostream* stream) { *stream << file.path.filename(); }

std::vector<TreeFile> TreeFiles() {
  std::vector<TreeFile> files;
  const std::filesystem::path trees = std::filesystem::path(SourceFolder()) / "trees";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(trees)) {
    const bool is_tree = entry.path().extension() == ".xml" && entry.path().parent_path() != trees;
    if (is_tree) files.push_back({entry.path()});
  }
  return files;
}

class TreeCoverage : public testing::TestWithParam<TreeFile> {
 protected:
  void Load(std::filesystem::path path) {
    Diagnostics diagnostics;
    const auto suite = LoadScenarios(path.replace_extension(".test.json").string(), diagnostics);
    ASSERT_TRUE(suite) << diagnostics.ToString();
    ASSERT_TRUE(suite->random) << "the file says nothing of chance";
    std::optional<Project> project = Project::FromFile(suite->tree_file, diagnostics);
    ASSERT_TRUE(project) << diagnostics.ToString();
    program_ = CompileSuite(*suite, *std::move(project), nullptr, diagnostics);
    ASSERT_TRUE(program_) << diagnostics.ToString();
    options_.play = *suite->random;
  }

  std::shared_ptr<const Program> program_;
  RandomRunOptions options_;
};

TEST_P(TreeCoverage, EveryNodeReturnsWhatItCan) {
  ASSERT_NO_FATAL_FAILURE(Load(GetParam().path));
  RandomRuns random(program_, options_);
  for (int i = 0; i < kRuns; ++i) random.Run();
  const Coverage& coverage = random.coverage();
  for (NodeIndex node{0}; node < program_->nodes.size(); ++node) {
    const std::filesystem::path file = program_->Location(node).file;
    if (file.filename() != GetParam().path.filename()) continue;
    const NodeCoverage& one = coverage.nodes[node];
    const Can can = WhatItCan(*program_, node);
    EXPECT_GT(one.ticks(), 0U) << one.path << " is never ticked";
    EXPECT_EQ(one.results_of(Status::kSuccess) > 0, can.succeed) << one.path << ": SUCCESS";
    EXPECT_EQ(one.results_of(Status::kFailure) > 0, can.fail) << one.path << ": FAILURE";
  }
  for (const RandomFinding& found : coverage.findings) {
    ADD_FAILURE() << found.node << ": " << found.text << " in the run of seed " << found.seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Trees, TreeCoverage, testing::ValuesIn(TreeFiles()),
                         [](const auto& file) { return file.param.path.stem().string(); });

}  // namespace
}  // namespace coppice
