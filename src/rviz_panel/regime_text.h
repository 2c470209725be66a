#pragma once

#include <poinsot/BodyStatus.h>

#include <QString>

namespace poinsot::rviz_panel {

/**
 * Returns what a body does, in words: "turns over; Ω circles the axis of largest moment". Whether it turns over or only
 * wobbles does not follow from the axis that Ω circles: a loop close to the separatrix turns over, a small one wobbles.
 */
QString regimeText(const BodyStatus& body);

}  // namespace poinsot::rviz_panel
