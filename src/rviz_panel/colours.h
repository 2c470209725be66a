#pragma once

#include <QColor>

/**
 * Colours of the plots, after Okabe and Ito. Energy and momentum are orange and blue as in the pictures; the three
 * components of Ω and the attitude error have none there.
 */
namespace poinsot::rviz_panel::colours {

inline const QColor kEnergy(230, 159, 0);
inline const QColor kMomentum(0, 114, 178);
inline const QColor kAttitudeError(40, 40, 40);
inline const QColor kOmega1(213, 94, 0);
inline const QColor kOmega2(40, 40, 40);
inline const QColor kOmega3(204, 121, 167);
inline const QColor kTrouble(178, 60, 0);
inline const QColor kPaper(252, 252, 250);
inline const QColor kGrid(225, 226, 228);

inline const QColor kDarkBackground(24, 28, 36);
inline const QColor kLightBackground(236, 239, 244);

}  // namespace poinsot::rviz_panel::colours
