#pragma once

#include <QColor>

/**
 * Colours of the plots. Energy and momentum are orange and blue, and the three principal axes red, green and sky blue,
 * as in the pictures. All stand out from the dark paper of the plots at a contrast of 3.3 : 1 or more. Axes 1 and 2
 * also differ in lightness (1.6 : 1), for eyes that confuse red and green.
 */
namespace poinsot::rviz_panel::colours {

inline const QColor kEnergy(230, 159, 0);
inline const QColor kMomentum(0, 114, 178);
inline const QColor kAttitudeError(185, 105, 155);
inline const QColor kAxis1(232, 80, 91);   ///< of the first principal axis, in the order of `principal_moments`
inline const QColor kAxis2(95, 191, 74);   ///< of the second
inline const QColor kAxis3(86, 196, 232);  ///< of the third
inline const QColor kTrouble(178, 60, 0);
inline const QColor kPaper(24, 28, 36);
inline const QColor kGrid(58, 64, 76);

inline const QColor kDarkBackground(24, 28, 36);
inline const QColor kLightBackground(236, 239, 244);

}  // namespace poinsot::rviz_panel::colours
