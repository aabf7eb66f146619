// Leaves that look at people: SeesPeople, PersonInFront, NearestPerson, CountPeople,
// FollowerBehind, FollowerNear, MaskMissing, FacePerson. All read the key that perception feeds
// (`people`), never wait for it, and fail when it is older than a second: without perception nobody
// is there, and the tree goes on.
#ifndef COPPICE_BT_NODES_PEOPLE_PEOPLE_LEAVES_H_
#define COPPICE_BT_NODES_PEOPLE_PEOPLE_LEAVES_H_

#include <set>

#include "bt_nodes/basics/capability_action.h"
#include "bt_nodes/navigation/navigator.h"
#include "bt_nodes/people/people_view.h"

namespace coppice::leaves {

/// Who is older than that is not acted on [s].
inline constexpr double kOldestView = 1;
/// Who has not been seen for so long may be elsewhere [s].
inline constexpr double kOldestSight = 0.5;

using PeopleInput = Input<PeopleView>;

class SeesPeople : public Condition {
 public:
  static constexpr const char* kDescription =
      "Does perception tell who is around, be it that nobody is?";
  PeopleInput people{this, "people", "fed by perception", kOptional};
  bool Check() override;
};

class PersonInFront : public Condition {
 public:
  static constexpr const char* kDescription = "Has somebody been before the robot for a while?";
  PeopleInput people{this, "people", "fed by perception", kOptional};
  Input<double> distance{this, "distance", "at most [m]", 2.0};
  Input<double> angle{this, "angle", "to either side of straight ahead, at most [rad]", 0.5};
  Input<double> lasting{this, "lasting", "known for at least [s]", 1.0};
  Output<int> id{this, "id", "who it is; the nearest of several"};
  bool Check() override;
};

class NearestPerson : public SyncAction {
 public:
  static constexpr const char* kDescription =
      "Tells where the nearest person is; fails if nobody is.";
  PeopleInput people{this, "people", "fed by perception", kOptional};
  Output<int> id{this, "id", "who it is"};
  Output<double> distance{this, "distance", "from the robot's middle [m]"};
  Output<double> angle{this, "angle", "positive: to the left [rad]"};
  Status Run() override;
};

class CountPeople : public SyncAction {
 public:
  static constexpr const char* kDescription = "Counts the people around the robot.";
  PeopleInput people{this, "people", "fed by perception", kOptional};
  Input<double> distance{this, "distance", "up to [m]", 5.0};
  Output<int> count{this, "count", "all of them"};
  Output<int> with_mask{this, "with_mask", "whose face was seen with a mask"};
  Output<int> without_mask{this, "without_mask", "whose face was seen without"};
  Status Run() override;
};

class FollowerBehind : public Condition {
 public:
  static constexpr const char* kDescription = "Does somebody walk or stand behind the robot?";
  PeopleInput people{this, "people", "fed by perception", kOptional};
  Input<double> distance{this, "distance", "at most [m]", 3.0};
  Input<double> angle{this, "angle", "to either side of straight behind, at most [rad]", 0.8};
  Input<double> patience{this, "patience", "hidden for at most [s]", 2.0};
  bool Check() override;
};

class FollowerNear : public Condition {
 public:
  static constexpr const char* kDescription =
      "Is the follower near, also if hidden for a moment? Who has lost him takes whoever is behind "
      "or stands close.";
  PeopleInput people{this, "people", "fed by perception", kOptional};
  Input<double> distance{this, "distance", "at most [m]", 4.0};
  Input<double> patience{this, "patience", "hidden for at most [s]", 3.0};
  InOut<int> id{this, "id", "who it is; negative: the nearest of all becomes it"};
  Output<double> gap{this, "gap", "how far away [m]"};
  bool Check() override;

 private:
  bool IsNear(const SeenPerson& person) const;
};

class MaskMissing : public Condition {
 public:
  static constexpr const char* kDescription =
      "Is somebody without a mask near whom it has not yet told? Once for each person.";
  PeopleInput people{this, "people", "fed by perception", kOptional};
  Input<double> distance{this, "distance", "at most [m]", 3.0};
  Output<int> id{this, "id", "who it is"};
  bool Check() override;

 private:
  std::set<std::uint32_t> told_;  // of those who are around
};

class FacePerson : public CapabilityAction {
 public:
  static constexpr const char* kDescription =
      "Turns on the spot towards the nearest person; fails if nobody is seen.";
  explicit FacePerson(Navigator& navigator) : navigator_(navigator) {}
  PeopleInput people{this, "people", "fed by perception", kOptional};
  Input<double> speed{this, "speed", "how fast [rad/s], positive", 0.6};

 protected:
  void Begin(Sender<ActionResult> done) override;
  void Cancel() override { navigator_.CancelMotion(); }
  Turn* turn() override { return &navigator_.moving; }

 private:
  Navigator& navigator_;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_PEOPLE_PEOPLE_LEAVES_H_
