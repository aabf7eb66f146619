// Leaves that serve visitors: VisitorArrived, VisitorTalks, GuideRequested, RequestStands,
// SettleRequest, SayPhrase. All but the last read the key that what visitors say and touch feeds
// (`visitor`) and never wait for it: where nobody listens to visitors, nobody wants anything.
#ifndef COPPICE_BT_NODES_VISITORS_VISITOR_LEAVES_H_
#define COPPICE_BT_NODES_VISITORS_VISITOR_LEAVES_H_

#include <cstdint>
#include <set>
#include <string>

#include "bt_nodes/basics/capability_action.h"
#include "bt_nodes/interaction/interaction.h"
#include "bt_nodes/people/people_view.h"
#include "bt_nodes/visitors/phrases.h"
#include "bt_nodes/visitors/visitor.h"

namespace coppice::leaves {

using VisitorInput = Input<Visitor>;

class VisitorArrived : public Condition {
 public:
  static constexpr const char* kDescription =
      "Has somebody come who is not greeted yet? Who stands before the robot for a while, once for "
      "each person, or who touches the display.";
  Input<PeopleView> people{this, "people", "fed by perception", kOptional};
  VisitorInput visitor{this, "visitor", "fed by what visitors say and touch", kOptional};
  Input<double> distance{this, "distance", "at most [m]", 1.5};
  Input<double> angle{this, "angle", "to either side of straight ahead, at most [rad]", 0.5};
  Input<double> lasting{this, "lasting", "known for at least [s]", 1.0};
  Output<std::string> language{this, "language", "that is spoken with visitors now"};
  bool Check() override;

 private:
  bool HasArrived();
  void ForgetWhoHasGone(const PeopleView& view);
  bool IsBefore(const SeenPerson& person) const;

  std::set<std::uint32_t> greeted_;  // of those who are around
  int touches_ = 0;                  // that have been greeted
};

class VisitorTalks : public Condition {
 public:
  static constexpr const char* kDescription =
      "Does somebody talk with the robot, or use its display?";
  VisitorInput visitor{this, "visitor", "fed by what visitors say and touch", kOptional};
  Input<double> quiet{this, "quiet", "over when nothing was said or touched for so long [s]", 8.0};
  bool Check() override;
};

class GuideRequested : public Condition {
 public:
  static constexpr const char* kDescription =
      "Does a visitor want to be guided? A wish that waits for too long is none any more.";
  VisitorInput visitor{this, "visitor", "fed by what visitors say and touch", kOptional};
  Input<double> patience{this, "patience", "a visitor waits at most so long [s]", 60.0};
  Output<int> request{this, "request", "number of the wish"};
  Output<std::string> place{this, "place", "where to"};
  Output<std::string> language{this, "language", "that the visitor speaks"};
  bool Check() override;
};

class RequestStands : public Condition {
 public:
  static constexpr const char* kDescription =
      "Is the wish still what the visitor wants? Not if it was taken back, or another one came.";
  VisitorInput visitor{this, "visitor", "fed by what visitors say and touch", kOptional};
  Input<int> request{this, "request", "as GuideRequested gave it"};
  bool Check() override { return visitor.has_value() && visitor->request == *request; }
};

class SettleRequest : public SyncAction {
 public:
  static constexpr const char* kDescription = "The wish of a visitor has been dealt with.";
  explicit SettleRequest(Visitors& visitors) : visitors_(visitors) {}
  Input<int> request{this, "request", "as GuideRequested gave it"};
  Input<std::string> outcome{this, "outcome", "for people: arrived, lost, blocked ..."};
  Status Run() override {
    visitors_.Settle(*request, *outcome);
    return Status::kSuccess;
  }

 private:
  Visitors& visitors_;
};

class SayPhrase : public CapabilityAction {
 public:
  static constexpr const char* kDescription =
      "Says a phrase in the visitor's language; succeeds when it has been spoken.";
  SayPhrase(Interaction& interaction, Phrases& phrases)
      : interaction_(interaction), phrases_(phrases) {}
  Input<Phrase> phrase{this, "phrase", "which"};
  Input<std::string> language{this, "language", "en, de, ...", "en"};
  Input<std::string> about{this, "about", "what the phrase speaks of, such as a place", ""};

 protected:
  void Begin(Sender<ActionResult> done) override {
    interaction_.Say(phrases_.Text(*phrase, *language, *about), *language, done);
  }
  void Cancel() override { interaction_.CancelSpeech(); }
  Turn* turn() override { return &interaction_.turn; }

 private:
  Interaction& interaction_;
  Phrases& phrases_;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_VISITORS_VISITOR_LEAVES_H_
