#include "robot_app/deployment/robot/trees.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace coppice::robot::deployment {
namespace {

// Ticks that may wait for the recorder: its ring must not run full, or ticks would be left out.
constexpr int kMostUnflushed = 200;

std::shared_ptr<const Program> Load(const TreeOptions& options,
                                    const leaves::Capabilities& capabilities) {
  const auto registry = std::make_shared<Registry>();
  leaves::RegisterNodes(*registry, capabilities);
  Diagnostics diagnostics;
  auto program = CompileFile(options.file, registry, diagnostics);
  if (!program) throw std::runtime_error(diagnostics.ToString());
  return program;
}

}  // namespace

void Pretending::Install(Executor& executor, const std::vector<Pretended>& pretended,
                         const std::string& tree) {
  const Program& program = executor.program();
  std::vector<NodeIndex> nodes;
  for (NodeIndex node{0}; node < program.nodes.size(); ++node) {
    for (const Pretended& one : pretended) {
      if (one.tree != tree || one.node != program.Name(node)) continue;
      results_.emplace_back(node, one.result);
      nodes.push_back(node);
    }
  }
  for (const Pretended& one : pretended) {
    const bool is_there = std::any_of(
        nodes.begin(), nodes.end(), [&](NodeIndex node) { return program.Name(node) == one.node; });
    if (one.tree == tree && !is_there) {
      throw std::runtime_error("the " + tree + " tree has no node \"" + one.node + "\"");
    }
  }
  if (!nodes.empty()) executor.SetHooks(this, nodes);
}

std::optional<Status> Pretending::Before(NodeIndex node) {
  for (const auto& [known, result] : results_) {
    if (known == node) return result;
  }
  return std::nullopt;
}

Tree::Tree(const TreeOptions& options, const leaves::Capabilities& capabilities, Clock& clock)
    : program_(Load(options, capabilities)), executor_(program_, clock), stream_(executor_) {
  pretending_.Install(executor_, options.pretended, options.name);
  if (options.record.empty()) return;
  RecorderOptions recording;
  recording.metadata = {{"tree", options.name}};
  recording.run = options.run;
  recorder_ = std::make_unique<Recorder>(stream_, options.record, recording);
}

Time Tree::Due() const {
  if (is_suspended_) return is_halted_ ? kNever : Time{};
  const bool is_called = const_cast<Executor&>(executor_).inbox()->has_messages();
  return is_called ? Time{} : executor_.next_tick();
}

void Tree::Tick() {
  if (is_suspended_) {
    if (!is_halted_) executor_.Halt();
    is_halted_ = true;
    return;
  }
  is_halted_ = false;
  executor_.RunCalls();
  executor_.Tick();
  if (recorder_ && ++unflushed_ >= kMostUnflushed) {
    stream_.Flush();
    unflushed_ = 0;
  }
}

void Link::Connect(Tree* application, Tree* monitor) {
  application_ = application;
  charge_requested_ = application->executor().Writer<bool>("charge_requested");
  going_home_ = monitor->executor().Writer<bool>("going_home");
  charge_requested_.Send(false);
  going_home_.Send(false);
  is_going_home_ = false;
}

}  // namespace coppice::robot::deployment
