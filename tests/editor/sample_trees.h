// What several tests and scenes of the gallery show.
#ifndef COPPICE_TESTS_EDITOR_SAMPLE_TREES_H_
#define COPPICE_TESTS_EDITOR_SAMPLE_TREES_H_

namespace coppice::editor {

/// A file of a patrol to be simulated.
inline constexpr char kPatrolTree[] = R"(<root BTCPP_format="4" main_tree_to_execute="Patrol">
  <BehaviorTree ID="Patrol">
    <ReactiveFallback name="patrol">
      <Sequence name="recharge">
        <ScriptCondition name="low?" code="battery &lt; 0.3"/>
        <GoTo name="to station" place="station"/>
        <Dock name="dock"/>
      </Sequence>
      <KeepRunningUntilFailure name="rounds">
        <Sequence name="round">
          <GoTo name="to door" place="{door}"/>
          <Say name="say" text="All quiet."/>
        </Sequence>
      </KeepRunningUntilFailure>
    </ReactiveFallback>
  </BehaviorTree>
</root>
)";

/// A robot's tree with the key "processes", and what the process supervisor writes to it.
inline constexpr char kProcessTrees[] = R"(<BehaviorTree ID="Main"><Sequence name="monitor">
  <ForceSuccess><WasEntryUpdated name="changed" entry="{processes}"/></ForceSuccess>
  <Do as="watch" name="watch" count="{watched}"/></Sequence></BehaviorTree>)";

inline constexpr char kProcessRows[] = R"([
  {"name": "roscore", "group": "core", "state": "READY", "pid": 4211, "restarts": 0,
   "escalation": "group", "message": ""},
  {"name": "ekf", "group": "odometry_filter", "state": "BACKING_OFF", "pid": 0, "restarts": 4,
   "escalation": "closure", "message": "ended by signal 11"},
  {"name": "move_base", "group": "navigation", "state": "STARTING", "pid": 4299, "restarts": 1,
   "escalation": "group", "message": "waits for ekf"},
  {"name": "logger", "group": "log", "state": "STOPPED", "pid": 0, "restarts": 0,
   "escalation": "group", "message": ""},
  {"name": "camera", "group": "sensors", "state": "GIVEN_UP", "pid": 0, "restarts": 12,
   "escalation": "person", "message": "restarted 12 times in 10 minutes; a person was asked"}])";

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_SAMPLE_TREES_H_
