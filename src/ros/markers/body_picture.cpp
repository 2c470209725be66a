#include "poinsot/ros/markers/body_picture.h"

#include <algorithm>
#include <utility>

#include "markers/layout.h"
#include "markers/parts.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/view/facing.h"

namespace poinsot::node {
namespace {

using namespace parts;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

using Parts = std::vector<std::unique_ptr<Part>>;
using Still = void (*)(const Subject&, Canvas&);
using Moving = void (*)(const Subject&, const Now&, Canvas&);

/** A part without memory. */
class Plain : public Part {
 public:
  explicit Plain(Still still) : still_(still) {}
  explicit Plain(Moving moving) : moving_(moving) {}
  void appendStatic(const Subject& subject, Canvas& canvas) const override {
    if (still_) still_(subject, canvas);
  }
  void appendMoving(const Subject& subject, const Now& now, Canvas& canvas) override {
    if (moving_) moving_(subject, now, canvas);
  }

 private:
  Still still_ = nullptr;
  Moving moving_ = nullptr;
};

template <class... Arguments>
void add(Parts& list, void (*append)(Arguments...)) {
  list.push_back(std::make_unique<Plain>(append));
}

/** E and MΩ are constant, and so are the ellipsoids and curves. At rest there are none. */
void addFree(const Subject& subject, const Motion& motion, Parts& list) {
  if (subject.flies()) add(list, appendFlight);
  if (!subject.hasPictures()) return;
  for (const Still still : {appendPictureTitles, appendEllipsoidNames, appendConstruction, appendPolhodeFamily,
                            appendRolling, appendCones}) {
    add(list, still);
  }
  add(list, appendSpin);
  list.push_back(makeTrail(subject, motion));
  if (motion.conservesMomentum()) {
    add(list, appendStillMomentum);
  } else {
    add(list, appendMomentum);
  }
}

/** Ellipsoids and curves are those of the moment, and move. */
void addTorqued(const Subject& subject, const Motion& motion, Parts& list) {
  add(list, appendPictureTitles);
  add(list, appendEllipsoidNames);
  add(list, appendTorquedMomentum);
  list.push_back(makePath(!isPushed(motion)));
  list.push_back(makeTorquedConstruction());
  if (isPushed(motion)) add(list, appendTorque);
  if (subject.weight) {
    add(list, appendPivot);
    if (!subject.weight->centre_of_mass.isZero(0)) list.push_back(makeWay(subject));
    add(list, appendWeight);
  }
  if (subject.orbit) {
    add(list, appendPlanet);
    add(list, appendWayToCentre);
    list.push_back(makeOnOrbit(subject));
  }
}

Parts partsOf(const Subject& subject, const Motion& motion) {
  Parts list;
  add(list, appendShape);
  if (subject.wanted == scene::Pictures::none) return list;
  list.push_back(makeWords(subject, motion.setup()));
  add(list, appendBodyTitle);
  add(list, appendBodyAxes);
  (motion.torques() ? addTorqued : addFree)(subject, motion, list);
  return list;
}

/** Sets how the pictures are turned, and how large what they show is drawn. */
void layOut(Subject& subject, const Motion& motion, BodyPicture::Detail detail) {
  if (subject.weight) subject.swept = sweptOnPivot(subject, motion);
  view::PictureFrame& out = subject.frame;
  if (motion.torques() && detail == BodyPicture::Detail::pictures) {
    out.bounds = view::pictureBoundsOf(motion);
    out.scale = view::pictureScale(out.bounds.semi_axis, out.bounds.momentum);
  }
  const PrincipalInertia& inertia = subject.inertia;
  out.model_orientation = view::facingTheViewer(inertia.moments(), inertia.axes(), subject.polhode,
                                                subject.omega_principal, inertia.toPrincipal(out.bounds.omega_later));
}

}  // namespace

BodyPicture::BodyPicture(const scene::Body& body, const Motion& motion, const names::Frames& frames, Detail detail,
                         const std::optional<view::PictureFrame>& keep)
    : subject_(std::make_unique<Subject>(body, motion, frames)) {
  if (keep) {
    subject_->frame = *keep;
    setUnits(canvas_);
  } else {
    layOut(*subject_, motion, detail);
  }
  parts_ = partsOf(*subject_, motion);
}

BodyPicture::~BodyPicture() = default;

const view::PictureFrame& BodyPicture::frame() const {
  return subject_->frame;
}

bool BodyPicture::hasPictures() const {
  return subject_->hasPictures();
}

void BodyPicture::setUnits(Canvas& canvas) const {
  const view::PictureFrame& frame = subject_->frame;
  canvas.setUnits(subject_->factory.frames(), frame.unit, frame.text, frame.light_background);
}

view::BodyExtent BodyPicture::extent(const SceneFacts& scene) const {
  return extentOf(*subject_, scene);
}

void BodyPicture::place(const view::BodyPlace& place, const view::SceneLayout& layout, const SceneFacts& scene) {
  view::PictureFrame& frame = subject_->frame;
  frame.place = place;
  frame.unit = layout.unit;
  frame.text = layout.text;
  frame.loop = scene.loop;
  still_.clear();
  frame.light_background = scene.light_background;
  setUnits(canvas_);
}

void BodyPicture::faceViewer() {
  view::PictureFrame& frame = subject_->frame;
  if (!view::isBehind(frame, subject_->start.omega_body)) return;
  const PrincipalInertia& inertia = subject_->inertia;
  frame.model_orientation =
      view::facingTheViewer(inertia.moments(), inertia.axes(), subject_->polhode, subject_->omega_principal);
}

double BodyPicture::reach() const {
  return subject_->reach;
}

void BodyPicture::appendStatic(MarkerArray& out) const {
  if (still_.empty()) {
    Canvas canvas;
    setUnits(canvas);
    for (const auto& part : parts_) part->appendStatic(*subject_, canvas);
    still_ = canvas.take();
  }
  out.markers.insert(out.markers.end(), still_.begin(), still_.end());
}

void BodyPicture::appendMoving(const session::Tick& tick, const Motion& motion, const MotionState& state,
                               MarkerArray& out) {
  if (segment_ != tick.segment) {
    segment_ = tick.segment;
    clearTrail();
  }
  for (const auto& part : parts_) part->appendMoving(*subject_, {tick, motion, state}, canvas_);
  for (Marker& marker : canvas_.take()) {
    marker.header.stamp = toTime(tick.stamp);
    out.markers.push_back(std::move(marker));
  }
}

void BodyPicture::appendFigures(const session::Tick& tick, const Figures& figures, MarkerArray& out) {
  for (const auto& part : parts_) part->appendFigures(*subject_, tick, figures, canvas_);
  for (Marker& marker : canvas_.take()) out.markers.push_back(std::move(marker));
}

void BodyPicture::clearTrail() {
  for (const auto& part : parts_) part->clearTrail();
}

void BodyPicture::sendAllNext() {
  for (const auto& part : parts_) part->sendAllNext();
}

view::SceneLayout layOutScene(const std::vector<BodyPicture*>& pictures, SceneFacts scene) {
  scene.bodies = pictures.size();
  std::vector<view::BodyExtent> extents;
  for (const BodyPicture* picture : pictures) extents.push_back(picture->extent(scene));
  view::SceneLayout layout = view::sceneLayoutOf(extents);
  for (std::size_t i = 0; i < pictures.size(); ++i) pictures[i]->place(layout.bodies[i], layout, scene);
  return layout;
}

}  // namespace poinsot::node
