// The pictures of docs/perception.md: COPPICE_PICTURES=FOLDER writes them. What they show is what
// the tests assert.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <utility>

#include "robot_app/common/compressed_picture.h"
#include "robot_app/perception/drawing/floor_picture.h"
#include "robot_app/training/labelled_scan.h"
#include "robot_app/training/tracking_figures.h"
#include "tests/support/folders.h"

namespace coppice::robot::training {
namespace {

using perception::ColourOf;
using perception::FloorPicture;
using perception::SeenPerson;

constexpr double kReach = 6.6;  // of the hall [m]

void Save(const FloorPicture& picture, const std::string& name) {
  const char* const folder = std::getenv("COPPICE_PICTURES");
  if (folder == nullptr) return;
  const std::vector<std::uint8_t> jpeg = EncodeJpeg(picture.picture(), 90);
  std::ofstream(std::string(folder) + "/" + name, std::ios::binary)
      .write(reinterpret_cast<const char*>(jpeg.data()), static_cast<long>(jpeg.size()));
}

perception::PeopleFinder Finder() {
  auto classifier = perception::PersonClassifier::Load(
      SourceFolder() + "/robot_app/perception/data/people_in_clouds.yaml");
  EXPECT_TRUE(classifier) << classifier.problem();
  return {{}, std::move(*classifier)};
}

// Four in the open, one before a column, two side by side.
std::vector<simulation::Figure> Crowd() {
  std::vector<simulation::Stance> stances(6);
  const simulation::Vec2 places[] = {{3, 0.5},  {1, -3},    {-3.5, 1},
                                     {-1.5, 4}, {2.2, 1.5}, {2.9, 1.6}};
  for (std::size_t i = 0; i < stances.size(); ++i) {
    stances[i].position = places[i];
    stances[i].heading = static_cast<double>(i);
    stances[i].walks = i % 2 == 0;
    stances[i].walked = 0.3 * static_cast<double>(i);
  }
  return simulation::MakeFigures(stances);
}

std::vector<Eigen::Vector2d> PointsOf(const perception::RangeImage& image,
                                      perception::Clusters::Cells cells) {
  std::vector<Eigen::Vector2d> points;
  for (const std::uint32_t cell : cells) {
    points.push_back(image.points[cell].head<2>().cast<double>());
  }
  return points;
}

TEST(PerceptionPictures, AScanWithThePeopleInIt) {
  const Site hall = TrackingHall();
  simulation::Scene scene(hall.still);
  scene.SetFigures(Crowd());
  simulation::Lidar3d lidar({}, 1);
  for (double time = 0; lidar.cloud().points.empty(); time += 0.02) {
    lidar.Turn(time, 0.02, {0, 0, 0}, scene);
  }
  perception::PeopleFinder finder = Finder();
  const std::vector<SeenPerson>& people = finder.Find(ToPoints(lidar.cloud()));
  EXPECT_EQ(people.size(), 6u);

  const perception::RangeImage& image = finder.candidates().image();
  FloorPicture picture({0, 0}, kReach);
  std::vector<Eigen::Vector2d> standing;
  for (std::size_t cell = 0; cell < image.size(); ++cell) {
    if (finder.candidates().surfaces()[cell] == perception::Surface::kStanding) {
      standing.push_back(image.points[cell].head<2>().cast<double>());
    }
  }
  picture.DrawPoints(standing, perception::kGray);
  picture.DrawRobot({0, 0, 0});
  std::uint32_t number = 0;
  for (const SeenPerson& person : people) {
    const Colour colour = ColourOf(number++);
    picture.DrawPoints(PointsOf(image, finder.candidates().candidates()[person.cluster]), colour);
    char text[16];
    std::snprintf(text, sizeof(text), "%.0f %%", 100.0 * person.probability);
    picture.DrawPerson(person.position.cast<double>(), {0, 0}, text, colour);
  }
  Save(picture, "people_in_scan.jpg");
}

TEST(PerceptionPictures, TheWaysOfPeopleOverTheFloor) {
  std::map<std::uint32_t, std::vector<Eigen::Vector2d>> trails;
  std::vector<perception::Track> last;
  TrackingScenario scenario;
  scenario.seconds = 10;
  scenario.seed = 31;
  scenario.on_look = [&](double, const perception::Tracker& tracker) {
    last = tracker.tracks();
    for (const perception::Track& track : last) {
      if (track.is_confirmed) trails[track.id].push_back(track.position());
    }
  };
  perception::PeopleFinder finder = Finder();
  MeasureTracking({&finder, nullptr, nullptr}, scenario);
  EXPECT_GE(trails.size(), 8u);
  EXPECT_LE(trails.size(), 16u);

  FloorPicture picture({0, 0}, kReach);
  for (const simulation::Panel& panel : TrackingHall().still.panels) {
    picture.DrawWall({panel.edge.a.x, panel.edge.a.y}, {panel.edge.b.x, panel.edge.b.y});
  }
  picture.DrawRobot({0, 0, scenario.turning * scenario.seconds});
  for (const auto& [id, trail] : trails) picture.DrawTrail(trail, ColourOf(id));
  for (const perception::Track& track : last) {
    if (!track.is_confirmed) continue;
    picture.DrawPerson(track.position(), track.velocity(), std::to_string(track.id),
                       ColourOf(track.id));
  }
  Save(picture, "tracks.jpg");
}

}  // namespace
}  // namespace coppice::robot::training
