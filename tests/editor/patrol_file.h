// A robot that walks its round and charges when it must: every shape, keys, a note.
#ifndef COPPICE_TESTS_EDITOR_PATROL_FILE_H_
#define COPPICE_TESTS_EDITOR_PATROL_FILE_H_

namespace coppice::editor {

inline constexpr char kPatrolFile[] = R"(<?xml version="1.0" encoding="UTF-8"?>
<root BTCPP_format="4" main_tree_to_execute="Patrol">
  <BehaviorTree ID="Patrol">
    <ReactiveFallback name="patrol">
      <!-- Once it is on its way to the station it stays at it. -->
      <Sequence name="recharge when low">
        <IsBatteryLow level="{battery}" threshold="0.3"/>
        <SubTree ID="GoTo" name="to the station" goal="{station}"/>
        <Charge until="0.95" level="{battery}"/>
      </Sequence>
      <Repeat name="rounds" num_cycles="-1">
        <Sequence name="round">
          <ChooseWaypoint waypoint="{goal}"/>
          <SubTree ID="GoTo" name="to the waypoint" goal="{goal}"/>
          <Say text="All quiet."/>
        </Sequence>
      </Repeat>
    </ReactiveFallback>
  </BehaviorTree>
  <BehaviorTree ID="GoTo">
    <RetryUntilSuccessful name="until there" num_attempts="3">
      <Fallback name="drive or pause">
        <NavigateTo goal="{goal}"/>
        <ForceFailure name="pause"><Wait seconds="5"/></ForceFailure>
      </Fallback>
    </RetryUntilSuccessful>
  </BehaviorTree>
  <TreeNodesModel>
    <Condition ID="IsBatteryLow"><input_port name="level" type="double">of charge</input_port>
      <input_port name="threshold" type="double">low below it</input_port></Condition>
    <Action ID="Charge"><input_port name="level" type="double">of charge</input_port>
      <input_port name="until" type="double">level to leave at</input_port></Action>
    <Action ID="ChooseWaypoint"><output_port name="waypoint" type="Pose2D">next</output_port>
      </Action>
    <Action ID="NavigateTo"><input_port name="goal" type="Pose2D">where to</input_port></Action>
    <Action ID="Say"><input_port name="text" type="string">what</input_port></Action>
    <Action ID="Wait"><input_port name="seconds" type="double">how long</input_port></Action>
  </TreeNodesModel>
</root>
)";

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_PATROL_FILE_H_
