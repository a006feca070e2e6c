#pragma once

#include <QStringList>
#include <QVector>

#include "bob-weights/solver.h"
#include "workshop/model/words.h"

/// What page and job card say of a bob weight and of the correction.
namespace ravnoves::bob_text {

/// "V-8, 90°", "4 in line", "Boxer, 6".
QString engineName(const Words& words, const bob_weights::Engine& engine);
/// "Bob weight 1505.2 g", or what is missing.
QString headline(const Words& words, const bob_weights::Input& input,
                 const bob_weights::Result& result);
QString hang(const Words& words, const bob_weights::Engine& engine);
/// "Factor 50 % + 2 % overbalance, by theory 50 %. …"
QString factor(const Words& words, const bob_weights::Input& input,
               const bob_weights::Result& result);
QString limits(const Words& words, const bob_weights::Result& result);
QString planeName(const Words& words, std::size_t plane);
/// What falls short, plane by plane.
QStringList shortfalls(const Words& words, const bob_weights::Result& result);
/// Bob weight of each crankpin's own parts, and what to take off to match the lightest.
QString weighIn(const Words& words, const bob_weights::Result& result);
QString balance(const Words& words, bob_weights::Balance balance);

QStringList lineHead(const Words& words);
QVector<QStringList> lines(const Words& words, const bob_weights::Result& result);
QStringList planeHead(const Words& words);
QVector<QStringList> planes(const Words& words, const bob_weights::Result& result);
QStringList holeHead(const Words& words);
QVector<QStringList> holes(const Words& words, const bob_weights::Result& result);

}  // namespace ravnoves::bob_text
