// The people who look after the robot: the real help desk decides whom it asks and when; when they
// answer, whether they sleep, and what they then do is modelled.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_HELPERS_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_HELPERS_H_

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bt_nodes/operators/supervisor_channel.h"
#include "robot_app/assistance/help_desk.h"
#include "robot_app/deployment/scenario/chance.h"
#include "robot_app/deployment/world/world.h"

namespace coppice::robot::deployment {

class Helpers : public leaves::SupervisorChannel {
 public:
  Helpers(World& world, std::vector<assistance::HumanSupervisor> people,
          assistance::HelpDesk::RulesOf rules);

  void Ask(const std::string& subject, const std::string& question,
           Sender<leaves::ActionResult> done) override;
  void Withdraw(const std::string& subject) override;
  void Tell(const std::string& subject, const std::string& message) override;

  /// Moves on: deadlines, letters, answers. `is_up`: the program of the help desk works.
  void Step(bool is_up);
  bool is_asking() const { return open_ > 0; }
  /// Until somebody who has noticed something does something about it [s], as of now.
  double TimeToAct(double median);

  std::function<void(const std::string& subject)> on_help;  ///< a person repairs it

 private:
  struct Waiting {
    std::string subject;
    Sender<leaves::ActionResult> done;
    std::size_t entry = 0;  // in the journal
  };
  Time Awake(Time when) const;
  void Deliver(const assistance::Letter& letter);
  void Answer(std::uint32_t id, const std::string& by);
  void TakeOutcomes();
  void Close(const Waiting& waiting, bool is_fixed, const std::string& outcome);

  World& world_;
  assistance::HelpDesk desk_;
  Chance chance_;
  std::map<std::uint32_t, Waiting> waiting_;
  int open_ = 0;
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_ROBOT_HELPERS_H_
