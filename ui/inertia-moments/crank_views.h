#pragma once

#include <QCoreApplication>

class QWidget;

namespace ravnoves {

class InertiaMomentsModel;

/// The words of the pictures of the crank's balancing.
struct CrankViews {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::CrankViews)
};

/// The crank star with the rotating masses' force and moment and the counterweights of the end
/// webs (the paper's Fig. 9), crankpin 1 up.
QWidget* counterweightView(InertiaMomentsModel* model, QWidget* parent);
/// The firing order as a wheel of 720°, with the intervals and the present crank angle.
QWidget* firingWheel(InertiaMomentsModel* model, QWidget* parent);
/// Arrangement and phases of the balance shafts (the paper's Figs. 7 and 8), each at the present
/// crank angle: its target, its weights opposite, its direction, the cylinder axis and the crankpin
/// where its phase begins.
QWidget* shaftView(InertiaMomentsModel* model, QWidget* parent);

}  // namespace ravnoves
