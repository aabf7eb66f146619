#include "robot_app/training/mask_training.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

#include "robot_app/perception/detection/face_window.h"
#include "robot_app/perception/detection/mask_detector.h"
#include "robot_app/perception/detection/picture_view.h"
#include "robot_app/training/draw.h"
#include "robot_app/training/labelled_picture.h"

namespace coppice::robot::training {
namespace {

using perception::Box;
using perception::FaceExample;
using perception::MaskClassifier;
using perception::Sighting;
using perception::SightingKind;

constexpr int kCutsOfAFace = 4;     // each a little aside and of another size
constexpr int kOtherThings = 10;    // of a picture
constexpr double kNotAFace = 0.25;  // less in common with any face: something else
constexpr double kLeast = 0.5;      // confidence

struct Examples {
  std::vector<FaceExample> faces;
  std::vector<FaceExample> masks;
};

bool IsNoFace(const Box& box, const std::vector<Sighting>& faces) {
  return std::none_of(faces.begin(), faces.end(), [&](const Sighting& face) {
    return perception::Overlap(face.box, box) > kNotAFace;
  });
}

// The box of the detector's shape in the middle of the true one, about.
Box Cut(const Box& face, std::mt19937_64& random) {
  const double tall = face.height * Draw(random, 0.92, 1.09);
  const double wide = tall * perception::kFaceWide / perception::kFaceTall;
  return {face.x + face.width / 2 - wide / 2 + tall * Draw(random, -0.07, 0.07),
          face.y + face.height / 2 - tall / 2 + tall * Draw(random, -0.07, 0.07), wide, tall};
}

Box Anywhere(const Picture& picture, std::mt19937_64& random) {
  const double tall = perception::kFaceTall * Draw(random, 1, 6);
  return {Draw(random, 0, picture.width - tall), Draw(random, 0, picture.height - tall),
          tall * perception::kFaceWide / perception::kFaceTall, tall};
}

void AddFaces(const LabelledPicture& picture, std::mt19937_64& random, Examples& examples) {
  const cv::Mat view = perception::View(picture.colour);
  for (const Sighting& face : picture.faces) {
    for (int i = 0; i < kCutsOfAFace && face.confidence > 0; ++i) {
      auto features = DescribeFace(view, Cut(face.box, random));
      examples.masks.push_back({features, face.kind == SightingKind::kFaceWithMask});
      examples.faces.push_back({std::move(features), true});
    }
  }
}

void AddOther(const LabelledPicture& picture, const Box& box, Examples& examples) {
  if (!IsNoFace(box, picture.faces)) return;
  examples.faces.push_back({DescribeFace(perception::View(picture.colour), box), false});
}

// The first round learns from all faces and from whatever else; the others from what was wrong.
void AddExamples(const LabelledPicture& picture, perception::Detector* detector,
                 std::mt19937_64& random, Examples& examples) {
  if (detector != nullptr) {
    for (const Sighting& sighting : detector->Find(picture.colour)) {
      AddOther(picture, sighting.box, examples);
    }
    return;
  }
  AddFaces(picture, random, examples);
  for (int i = 0; i < kOtherThings; ++i) {
    AddOther(picture, Anywhere(picture.colour, random), examples);
  }
}

Expected<MaskClassifier> Learn(const Examples& examples) {
  auto face = perception::LearnPlane(examples.faces, perception::kFaceShapes);
  if (!face) return Problem{face.problem()};
  auto mask = perception::LearnPlane(examples.masks, perception::kFaceFeatures);
  if (!mask) return Problem{mask.problem()};
  return MaskClassifier{std::move(*face), std::move(*mask)};
}

std::vector<Sighting> OfKind(const std::vector<Sighting>& sightings, SightingKind kind) {
  std::vector<Sighting> some;
  std::copy_if(sightings.begin(), sightings.end(), std::back_inserter(some),
               [kind](const Sighting& sighting) { return sighting.kind == kind; });
  return some;
}

}  // namespace

Expected<MaskClassifier> TrainMasks(const MaskTrainingOptions& options,
                                    const std::function<void(double)>& say) {
  Examples examples;
  MaskClassifier classifier;
  std::unique_ptr<perception::Detector> detector;
  for (int round = 0; round < options.rounds; ++round) {
    std::mt19937_64 random(options.seed);  // the same pictures
    std::mt19937_64 cuts(options.seed + 1);
    for (int i = 0; i < options.pictures; ++i) {
      AddExamples(MakeLabelledPicture(random), detector.get(), cuts, examples);
      say((round + static_cast<double>(i) / options.pictures) / options.rounds);
    }
    auto learnt = Learn(examples);
    if (!learnt) return Problem{learnt.problem()};
    classifier = std::move(*learnt);
    detector = perception::MakeMaskDetector(classifier);
  }
  return classifier;
}

MaskFigures MeasureMasks(perception::Detector& detector, int pictures, std::uint64_t seed,
                         bool with_depth) {
  std::mt19937_64 random(seed);
  MaskFigures figures;
  for (; figures.pictures < pictures; ++figures.pictures) {
    const LabelledPicture picture = MakeLabelledPicture(random);
    const auto begin = std::chrono::steady_clock::now();
    const auto seen =
        detector.Find({picture.colour, with_depth ? &picture.depth : nullptr, picture.focal});
    figures.seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const auto add = [&](SightingKind kind, DetectionFigures& of_kind) {
      of_kind.Add(OfKind(picture.faces, kind), OfKind(seen, kind));
    };
    add(SightingKind::kFaceWithMask, figures.with_mask);
    add(SightingKind::kFaceWithoutMask, figures.without_mask);
  }
  return figures;
}

std::string Table(const MaskFigures& figures) {
  std::string text =
      "| face | average precision | of the paper | precision | recall |\n|---|---|---|---|---|\n";
  const auto add = [&](const char* name, const DetectionFigures& of_kind, double paper) {
    char line[160];
    std::snprintf(line, sizeof(line), "| %s | %.1f %% | %.2f %% | %.1f %% | %.1f %% of %d |\n",
                  name, 100 * of_kind.average_precision(), paper, 100 * of_kind.precision(kLeast),
                  100 * of_kind.recall(kLeast), of_kind.there());
    text += line;
  };
  add("with mask", figures.with_mask, 92.9);
  add("without mask", figures.without_mask, 82.34);
  char end[80];
  std::snprintf(end, sizeof(end), "\n%d pictures, %.0f ms each\n", figures.pictures,
                1e3 * figures.seconds / std::max(figures.pictures, 1));
  return text + end;
}

}  // namespace coppice::robot::training
