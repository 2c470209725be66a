#include "regime_text.h"

namespace poinsot::rviz_panel {

QString regimeText(const BodyStatus& body) {
  const QString does = body.flips ? "turns over; " : "wobbles; ";
  switch (body.regime_kind) {
    case BodyStatus::ABOUT_SMALLEST:
      return does + "Ω circles the axis of smallest moment";
    case BodyStatus::ABOUT_LARGEST:
      return does + "Ω circles the axis of largest moment";
    case BodyStatus::CIRCLE:
      return does + "Ω circles the axis of symmetry";
    case BodyStatus::SEPARATRIX:
      return "on the separatrix: turns over once, and never again";
    case BodyStatus::BESIDE_SEPARATRIX:
      return "on the separatrix, to rounding: turns over seldom";
    case BodyStatus::STEADY:
      return QString::fromStdString(body.regime).replace("steady", "steady spin");
    default:
      return QString::fromStdString(body.regime);
  }
}

}  // namespace poinsot::rviz_panel
