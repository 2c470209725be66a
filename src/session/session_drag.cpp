// What hands do to the bodies' spins.
#include <exception>
#include <stdexcept>

#include "poinsot/core/number_text.h"
#include "poinsot/scene/changes.h"
#include "poinsot/scene/reader.h"
#include "poinsot/session/session.h"
#include "poinsot/view/spin_choices.h"

namespace poinsot::session {
namespace {

const char* const kExpectedSpin = "expected a body that spins, got one at rest; ~set_spin and ~reset give it a spin";

}  // namespace

Eigen::Vector3d omegaPoint(const Body& body) {
  return view::scaleInMetres(body.companion().frame()).metres_per_radian_per_second * body.state().omega_body;
}

void Session::touch(const HandleEvent& event, Nanoseconds now, const std::optional<Eigen::Vector3d>& eye,
                    const std::string& frame) {
  try {
    handle(event, now, eye, frame);
  } catch (const std::exception& error) {
    refuse(SetSpin{event.body, Eigen::Vector3d::Zero()}, error.what());
  }
}

void Session::handle(const HandleEvent& event, Nanoseconds now, const std::optional<Eigen::Vector3d>& eye,
                     const std::string& frame) {
  using Kind = HandleEvent::Kind;
  const bool holds_it = drag_.isHeld() && drag_.isOn(event.body);
  switch (event.kind) {
    case Kind::reset:
      ask(Reset{});
      return;
    case Kind::keep:
      keep_ = event.keep;
      listener_.keepsAnotherEllipsoid(keep_);
      return;
    case Kind::press:
      press(*bodies_[indexOf(playing_.scene, event.body)], now);
      return;
    case Kind::lead:
      lead(event, now, eye, frame);
      return;
    case Kind::hold:
      if (holds_it) drag_.touch(now);
      return;
    case Kind::let_go:
      if (holds_it) letGo();
      return;
    case Kind::axis:
    case Kind::near:
    case Kind::separatrix:
      choose(event);
      return;
  }
}

void Session::press(const Body& body, Nanoseconds now) {
  if (drag_.isHeld() && drag_.isOn(body.name())) return;
  endDrag();
  drag_.press(body.name(), omegaPoint(body), body.companion().frame().unit, clock_.paused(), now);
  clock_.pause(true);
}

void Session::lead(const HandleEvent& event, Nanoseconds now, const std::optional<Eigen::Vector3d>& eye,
                   const std::string& frame) {
  const std::string grip = "grip of " + event.body + ": ";
  const std::size_t i = indexOf(playing_.scene, event.body);
  const Body& body = *bodies_[i];
  if (event.frame != frame) {
    throw scene::Error(grip + "expected a point in frame " + frame + ", got one in frame \"" + event.frame + "\"");
  }
  if (body.state().omega_body.isZero(0)) throw scene::Error(grip + kExpectedSpin);
  const std::optional<Eigen::Vector3d> omega_body = ledTo(
      {body.motion().setup().inertia, body.state().omega_body, body.companion().frame(), keep_}, event.point, eye);
  if (!omega_body) {
    throw scene::Error(grip + "expected a finite point (m) off the centre, got (" + numberText(event.point.x()) + ", " +
                       numberText(event.point.y()) + ", " + numberText(event.point.z()) + ")");
  }
  press(body, now);
  drag_.touch(now);
  if (!drag_.leads(event.point, omegaPoint(body))) return;
  drag_.leadTo(*omega_body);
  scene::Body start = scene::withSpin(playing_.scene.bodies[i], body.state(), *omega_body);
  if (start.effects.empty()) {
    start.method = kClosedForm;  // only its start is looked at
    start.step.reset();
  }
  preview_ = std::make_unique<Body>(start, options_.companions({bodies_[i].get()}, Redraw::never));
  listener_.previewChanged(body.name());
}

void Session::letGo() {
  if (drag_.state() == SpinDrag::State::pressed) {
    endDrag();
    return;
  }
  drag_.letGo();
  ask(SetSpin{drag_.body(), drag_.omegaBody()}, [this, body = drag_.body()](const Answer& answer) {
    const bool still = drag_.state() == SpinDrag::State::let_go && drag_.isOn(body);
    if (answer.refusal && still) endDrag();
  });
}

void Session::endDrag() {
  if (drag_.state() == SpinDrag::State::free) return;
  clock_.pause(drag_.wasPaused());
  drag_.end();
  if (!preview_) return;
  preview_.reset();
  listener_.previewEnded(drag_.body());
}

void Session::choose(const HandleEvent& event) {
  const Body& body = *bodies_[indexOf(playing_.scene, event.body)];
  endDrag();
  const PrincipalInertia& inertia = body.motion().setup().inertia;
  const Eigen::Vector3d omega = inertia.toPrincipal(body.state().omega_body);
  if (omega.isZero(0)) throw scene::Error("spin of " + event.body + ": " + kExpectedSpin);
  Eigen::Vector3d chosen;
  if (event.kind == HandleEvent::Kind::axis) {
    chosen = view::axisSpin(inertia.moments(), omega, keep_, event.axis);
  } else if (event.kind == HandleEvent::Kind::near) {
    chosen = view::nearAxis(inertia.moments(), omega, keep_, event.axis);
  } else {
    try {
      chosen = view::onSeparatrix(inertia.moments(), omega, keep_);
    } catch (const std::invalid_argument& error) {
      throw scene::Error("spin of " + event.body +
                         ": expected a spin about or near an axis, got the separatrix: " + error.what());
    }
  }
  ask(SetSpin{event.body, inertia.toBody(chosen)});
}

}  // namespace poinsot::session
