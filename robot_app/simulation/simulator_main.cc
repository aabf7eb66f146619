#include "robot_app/simulation/simulator_node.h"

int main(int argc, char** argv) { return coppice::robot::simulation::RunSimulator(argc, argv); }
