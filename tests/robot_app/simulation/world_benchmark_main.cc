// How fast the world is. Run it by hand: robot_simulation_benchmark
#include <benchmark/benchmark.h>

#include "robot_app/common/compressed_picture.h"
#include "robot_app/simulation/camera/rgbd_camera.h"
#include "robot_app/simulation/world.h"
#include "tests/robot_app/simulation/test_floor.h"

namespace coppice::robot::simulation {
namespace {

// One simulated second per iteration: the items per second are the factor of real time.
void BM_SimulatedSecond(benchmark::State& state) {
  WorldOptions options;
  options.start = Pose2{46, 0, 0};
  options.lidar.beams = static_cast<int>(state.range(0));
  World world(LoadInstitute(), options);
  for (auto unused : state) {
    for (int i = 0; i < 50; ++i) world.Step(0.02, Velocity{0.4, 0.4});
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(BM_SimulatedSecond)->Arg(61)->Arg(541);

void BM_Ray(benchmark::State& state) {
  const RayCaster caster(EdgesOf(World(LoadInstitute()).still()));
  double angle = 0;
  for (auto unused : state) {
    for (int i = 0; i < 541; ++i) {
      const Vec2 direction = Direction(angle += 0.0087);
      benchmark::DoNotOptimize(caster.Cast({20.3, 0.2}, direction, 20));
    }
  }
  state.SetItemsProcessed(state.iterations() * 541);
}
BENCHMARK(BM_Ray);

// A turn of the 3-D lidar among ten people.
void BM_Turn3d(benchmark::State& state) {
  Floor floor = LoadInstitute();
  for (int i = static_cast<int>(floor.people.size()); i < 10; ++i) {
    floor.people.push_back({"p", 1, {{17.0 + i, -0.8}, {30.0, -0.8}}});
  }
  WorldOptions options;
  options.start = Pose2{20, 0, 0};
  World world(floor, options);
  People people(floor.people);
  Scene scene(world.still());
  Lidar3d lidar({}, 1);
  for (auto unused : state) {
    scene.SetFigures(MakeFigures(people.Stances()));
    lidar.Turn(0, lidar.options().period, world.robot(), scene);
  }
}
BENCHMARK(BM_Turn3d)->Unit(benchmark::kMillisecond);

// What the three sonars hear once, among the same people.
void BM_Sonars(benchmark::State& state) {
  Floor floor = LoadInstitute();
  Scene scene(World(floor).still());
  scene.SetFigures(MakeFigures(People(floor.people).Stances()));
  std::vector<Sonar> sonars;
  for (const SonarOptions& options : ShippedSonars()) sonars.emplace_back(options, 1);
  for (auto unused : state) {
    for (Sonar& sonar : sonars) benchmark::DoNotOptimize(sonar.Measure({20, 0, 0}, scene));
  }
}
BENCHMARK(BM_Sonars)->Unit(benchmark::kMicrosecond);

// A picture of the RGB-D camera in the corridor, two people in it; and both encodings of it.
RgbdPicture TakePicture(const World& world, RgbdCamera& camera) {
  std::vector<SeenPerson> people(2);
  people[0].stance.position = {23, 0.4};
  people[1].stance.position = {25, -0.4};
  return camera.Take(Scene(world.still()), people, {20, 0, 0}, 1.35);
}

void BM_Picture(benchmark::State& state) {
  const World world(LoadInstitute());
  RgbdCamera camera({}, 1);
  for (auto unused : state) benchmark::DoNotOptimize(TakePicture(world, camera));
}
BENCHMARK(BM_Picture)->Unit(benchmark::kMillisecond);

void BM_EncodePicture(benchmark::State& state) {
  RgbdCamera camera({}, 1);
  const RgbdPicture picture = TakePicture(World(LoadInstitute()), camera);
  for (auto unused : state) {
    benchmark::DoNotOptimize(EncodeJpeg(picture.colour));
    benchmark::DoNotOptimize(EncodeDepth(picture.depth));
  }
}
BENCHMARK(BM_EncodePicture)->Unit(benchmark::kMillisecond);

void BM_RebuildAfterADoor(benchmark::State& state) {
  World world(LoadInstitute());
  bool open = false;
  for (auto unused : state) benchmark::DoNotOptimize(world.SetDoorOpen("door_101", open = !open));
}
BENCHMARK(BM_RebuildAfterADoor);

}  // namespace
}  // namespace coppice::robot::simulation

BENCHMARK_MAIN();
