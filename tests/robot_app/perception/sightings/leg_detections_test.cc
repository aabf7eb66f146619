#include "robot_app/perception/sightings/leg_detections.h"

#include <gtest/gtest.h>

namespace coppice::robot::perception {
namespace {

TEST(LegDetections, APersonIsPutWhereTheLaserStoodAndLooked) {
  SeenLegs person;
  person.position = {2, 0};
  person.covariance(0, 0) = 0.04F;
  person.covariance(1, 1) = 0.01F;
  const Detection detection = ToDetection(person, {1, 1, 1.5707963});
  EXPECT_NEAR(detection.position.x(), 1, 1e-6);
  EXPECT_NEAR(detection.position.y(), 3, 1e-6);
  EXPECT_NEAR(detection.covariance(1, 1), 0.04, 1e-6);
  EXPECT_EQ(detection.modality, Modality::kLaser);
}

TEST(LegDetections, NoSingleScanIsSure) {
  SeenLegs person;
  person.probability = 1;
  EXPECT_EQ(ToDetection(person, {}).probability, 0.8);
}

}  // namespace
}  // namespace coppice::robot::perception
