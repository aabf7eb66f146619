// Capabilities that remember what they were asked and answer when the test says so.
#ifndef COPPICE_TESTS_BT_NODES_FAKES_H_
#define COPPICE_TESTS_BT_NODES_FAKES_H_

#include <map>
#include <string>
#include <vector>

#include "bt_nodes/register_nodes.h"

namespace coppice::leaves {

/// Everything a robot can be asked, as a list of lines, for example "NavigateTo 1;2;0".
class FakeRobot : public Navigator,
                  public WaypointMap,
                  public Routes,
                  public ChargingStation,
                  public Interaction,
                  public Face,
                  public Visitors,
                  public Phrases,
                  public ProcessManager,
                  public SupervisorChannel,
                  public ApplicationControl,
                  public RecoveryLog {
 public:
  std::vector<std::string> calls;
  std::vector<std::string> voices;  ///< languages in which something was said
  std::vector<RecoveryEvent> events;
  std::map<std::string, Sender<ActionResult>> open_requests;  ///< for help, by subject

  /// A person answers the request.
  void AnswerRequest(const std::string& subject, bool fixed) {
    open_requests.at(subject).Send({fixed, fixed ? "" : "nobody could"});
    open_requests.erase(subject);
  }
  Sender<ActionResult> done;  ///< of the last action; requests for help have their own

  void NavigateTo(const Pose2D& goal, Sender<ActionResult> sender) override {
    Begin("NavigateTo " + ValueTraits<Pose2D>::Print(goal), sender);
  }
  void CancelNavigation() override { calls.push_back("CancelNavigation"); }
  void LimitSpeed(double speed) override { calls.push_back("LimitSpeed " + Text(speed)); }
  void FindWay(const Pose2D& goal, Sender<ActionResult> sender) override {
    Begin("FindWay " + ValueTraits<Pose2D>::Print(goal), sender);
  }
  void Move(double distance, double speed, Sender<ActionResult> sender) override {
    Begin("Move " + Text(distance) + " " + Text(speed), sender);
  }
  void Rotate(double angle, double speed, Sender<ActionResult> sender) override {
    Begin("Rotate " + Text(angle) + " " + Text(speed), sender);
  }
  void CancelMotion() override { calls.push_back("CancelMotion"); }

  Waypoint ChooseForPatrol() override {
    legs = {{"-> hall", "drive", {46, 0, 1}, "the hall"}};
    return {"hall", {46, 0, 1}};
  }
  bool Find(const std::string& name, Waypoint& waypoint) const override {
    if (name != "hall" && name != "staging") return false;
    waypoint = {name, {46, 0, 1}};
    return true;
  }

  std::vector<std::string> languages;  ///< in which legs were asked for
  std::vector<RouteLeg> legs;          ///< that are left of the way to any place but "nowhere"
  bool IsAt(const Pose2D&, const std::string& place) override {
    return place != "nowhere" && legs.empty();
  }
  Expected<std::optional<RouteLeg>> NextLeg(const Pose2D&, const std::string& place,
                                            const std::string& language) override {
    languages.push_back(language);
    if (place == "nowhere") return Problem{"there is no place \"nowhere\""};
    if (legs.empty()) return std::optional<RouteLeg>();
    return std::optional<RouteLeg>(legs.front());
  }
  void Ended(const std::string& leg, bool travelled, const Pose2D&) override {
    calls.push_back((travelled ? "travelled " : "blocked ") + leg);
    if (travelled && !legs.empty()) legs.erase(legs.begin());
  }
  Expected<std::string> Nearest(const Pose2D&, const std::string& category) override {
    if (category == "meeting_point") return std::string("lift");
    if (category != "office") return Problem{"there is no " + category};
    return std::string("office_103");
  }
  Expected<Description> Describe(const Pose2D&, const std::string& place,
                                 const std::string& language) override {
    if (place == "nowhere") return Problem{"there is no place \"nowhere\""};
    return Description{place + " in " + language, place == "upstairs" ? "Take the stairs." : ""};
  }

  void Dock(double lateral_offset, int attempts, Sender<ActionResult> sender) override {
    Begin("Dock " + Text(lateral_offset) + " " + std::to_string(attempts), sender);
  }
  void PressOn(Sender<ActionResult> sender) override { Begin("PressOn", sender); }
  void Undock(Sender<ActionResult> sender) override { Begin("Undock", sender); }
  void CancelDocking() override { calls.push_back("CancelDocking"); }

  void Say(const std::string& text, const std::string& language,
           Sender<ActionResult> sender) override {
    voices.push_back(language);
    Begin("Say " + text, sender);
  }
  void CancelSpeech() override { calls.push_back("CancelSpeech"); }
  void SetExpression(Expression expression) override { Look("SetExpression ", expression); }
  void Hold(Expression expression) override { Look("Hold ", expression); }
  void Release(Expression expression) override { Look("Release ", expression); }

  void Settle(int request, const std::string& outcome) override {
    calls.push_back("Settle " + std::to_string(request) + " " + outcome);
  }
  std::string Text(Phrase phrase, const std::string& language, const std::string& name) override {
    return ValueTraits<Phrase>::Print(phrase) + " " + language + (name.empty() ? "" : " " + name);
  }

  void RestartNode(const std::string& node, bool cleared, Sender<ActionResult> sender) override {
    Begin("RestartNode " + node + (cleared ? ", cleared" : ""), sender);
  }
  void SetConfiguration(const std::string& configuration) override {
    calls.push_back("SetConfiguration " + configuration);
  }

  void SetSite(const std::string& site, Sender<ActionResult> sender) override {
    Begin("SetSite " + site, sender);
  }
  void SwitchOff(const std::string& reason, Sender<ActionResult> sender) override {
    Begin("SwitchOff " + reason, sender);
  }

  void Ask(const std::string& subject, const std::string& question,
           Sender<ActionResult> sender) override {
    calls.push_back("Ask " + subject + ": " + question);
    open_requests[subject] = sender;
  }
  void Withdraw(const std::string& subject) override {
    calls.push_back("Withdraw " + subject);
    open_requests.erase(subject);
  }
  void Tell(const std::string& subject, const std::string& message) override {
    calls.push_back("Tell " + subject + ": " + message);
  }

  void SetChargeRequested(bool requested) override {
    calls.push_back(std::string("SetChargeRequested ") + (requested ? "true" : "false"));
  }
  void SetGoingHome(bool going_home) override {
    calls.push_back(std::string("SetGoingHome ") + (going_home ? "true" : "false"));
  }
  void Suspend() override { calls.push_back("Suspend"); }
  void Resume() override { calls.push_back("Resume"); }

  void Record(const RecoveryEvent& event) override { events.push_back(event); }

  Capabilities capabilities() {
    return {*this, *this, *this, *this, *this, *this, *this, *this, *this, *this, *this, *this};
  }

 private:
  static std::string Text(double number) { return ValueTraits<double>::Print(number); }
  void Look(const std::string& how, Expression expression) {
    calls.push_back(how + ValueTraits<Expression>::Print(expression));
  }
  void Begin(std::string call, const Sender<ActionResult>& sender) {
    calls.push_back(std::move(call));
    done = sender;
  }
};

}  // namespace coppice::leaves

#endif  // COPPICE_TESTS_BT_NODES_FAKES_H_
