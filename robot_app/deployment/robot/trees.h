// The two trees of the robot in one process: each is ticked when something happens or one of its
// timers is due, as its thread would do in the robot, and may be recorded.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_TREES_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_TREES_H_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/engine/events/event_stream.h"
#include "bt_core/engine/executor.h"
#include "bt_core/engine/node_hooks.h"
#include "bt_core/record/recorder.h"
#include "bt_nodes/application/application_control.h"
#include "bt_nodes/register_nodes.h"
#include "robot_app/deployment/robot/controller.h"

namespace coppice::robot::deployment {

/// Ablations: gives the results of chosen nodes.
class Pretending : public NodeHooks {
 public:
  void Install(Executor& executor, const std::vector<Pretended>& pretended,
               const std::string& tree);
  std::optional<Status> Before(NodeIndex node) override;
  std::optional<Status> After(NodeIndex, Status) override { return std::nullopt; }

 private:
  std::vector<std::pair<NodeIndex, Status>> results_;
};

struct TreeOptions {
  std::string name;  ///< "application", "monitor"
  std::string file;
  std::string record;  ///< file to record to; empty: none
  RunId run{};         ///< of the record
  std::vector<Pretended> pretended;
};

class Tree {
 public:
  /// Throws std::runtime_error if the file cannot run.
  Tree(const TreeOptions& options, const leaves::Capabilities& capabilities, Clock& clock);

  Executor& executor() { return executor_; }
  /// When it is to be ticked next; in the past: now.
  Time Due() const;
  void Tick();
  void Suspend() { is_suspended_ = true; }
  void Resume() { is_suspended_ = false; }

 private:
  std::shared_ptr<const Program> program_;
  Executor executor_;
  EventStream stream_;
  std::unique_ptr<Recorder> recorder_;
  Pretending pretending_;
  bool is_suspended_ = false;
  bool is_halted_ = false;  // since it was suspended
  int unflushed_ = 0;
};

/// How the trees speak with each other; as TreeLink of the real robot.
class Link : public leaves::ApplicationControl {
 public:
  void Connect(Tree* application, Tree* monitor);
  void SetChargeRequested(bool requested) override { charge_requested_.Send(requested); }
  void SetGoingHome(bool going_home) override {
    is_going_home_ = going_home;
    going_home_.Send(going_home);
  }
  void Suspend() override {
    if (application_) application_->Suspend();
  }
  void Resume() override {
    if (application_) application_->Resume();
  }
  bool is_going_home() const { return is_going_home_; }

 private:
  Tree* application_ = nullptr;
  Sender<bool> charge_requested_, going_home_;
  bool is_going_home_ = false;
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_TREES_H_
