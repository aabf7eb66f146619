// What the robot shows and says to people: speech takes its time, the rest is not modelled. And
// what is done against faults, into the journal.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_SURFACE_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_SURFACE_H_

#include <functional>
#include <string>

#include "bt_nodes/interaction/expression.h"
#include "bt_nodes/interaction/interaction.h"
#include "bt_nodes/recovery/recovery_log.h"
#include "bt_nodes/visitors/visitor.h"
#include "robot_app/deployment/robot/programs.h"
#include "robot_app/deployment/world/world.h"

namespace coppice::robot::deployment {

class Surface : public leaves::Interaction,
                public leaves::Face,
                public leaves::Visitors,
                public leaves::RecoveryLog {
 public:
  Surface(World& world, const Programs& programs) : world_(world), programs_(programs) {}

  void Say(const std::string& text, const std::string& /*language*/,
           Sender<leaves::ActionResult> done) override {
    CancelSpeech();
    const double letters = static_cast<double>(text.size());
    const bool speaks = programs_.Works("/speech");
    speech_ = world_.After(speaks ? 0.5 + kPerLetter * letters : 1, [done, speaks] {
      done.Send({speaks, speaks ? "" : "the server is gone"});
    });
  }
  void CancelSpeech() override { world_.events.Cancel(speech_); }

  void SetExpression(leaves::Expression) override {}
  void Hold(leaves::Expression) override {}
  void Release(leaves::Expression) override {}
  void Settle(int, const std::string&) override {}

  void Record(const leaves::RecoveryEvent& event) override {
    world_.journal.recoveries.push_back(event);
    if (event.phase == leaves::RecoveryPhase::kBegun) ++running_;
    const bool has_ended = event.phase == leaves::RecoveryPhase::kSucceeded ||
                           event.phase == leaves::RecoveryPhase::kFailed ||
                           event.phase == leaves::RecoveryPhase::kInterrupted;
    if (has_ended && running_ > 0) --running_;
    if (on_recovery) on_recovery();
  }
  /// Something is being done against a fault.
  bool is_recovering() const { return running_ > 0; }
  void ForgetRecoveries() { running_ = 0; }

  std::function<void()> on_recovery;

 private:
  static constexpr double kPerLetter = 0.06;  // s, as espeak-ng speaks

  World& world_;
  const Programs& programs_;
  EventQueue::Id speech_{};
  int running_ = 0;
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_SURFACE_H_
