#include "robot_app/simulation/simulator_node.h"

int main(int argc, char** argv) { return coppice::robot::RunSimulator(argc, argv); }
