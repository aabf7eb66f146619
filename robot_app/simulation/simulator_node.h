// The program coppice-simulator: a World on ROS topics. docs of its topics, parameters and faults
// are printed by `coppice-simulator --help`.
#ifndef COPPICE_ROBOT_APP_SIMULATION_SIMULATOR_NODE_H_
#define COPPICE_ROBOT_APP_SIMULATION_SIMULATOR_NODE_H_

namespace coppice::robot::simulation {

/// Runs the node `/simulator` until SIGTERM, SIGINT or a shutdown request by XML-RPC, in the
/// calling thread. Returns the exit code: 0, or 2 after one line on stderr that says what is wrong
/// (no ROS master, a bad floor description, a bad parameter). Call it once per process.
int RunSimulator(int argc, char** argv);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_SIMULATOR_NODE_H_
