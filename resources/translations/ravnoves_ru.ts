<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru_RU">
<context>
    <name>BobWeights</name>
    <message>
        <source>Balanced</source>
        <translation>Балансировка</translation>
    </message>
    <message>
        <source>Bob weight, line by line</source>
        <translation>Балансировочный груз по строкам</translation>
    </message>
    <message>
        <source>Correction planes</source>
        <translation>Плоскости коррекции</translation>
    </message>
    <message>
        <source>Bob weight %1</source>
        <translation>Балансировочный груз %1</translation>
    </message>
    <message>
        <source>V-%1, %2</source>
        <translation>V-%1, %2</translation>
    </message>
    <message>
        <source>%1 in line</source>
        <translation>Рядный, %1</translation>
    </message>
    <message>
        <source>Boxer, %1</source>
        <translation>Оппозитный, %1</translation>
    </message>
    <message>
        <source>On each of the %1 crankpins.</source>
        <translation>На каждую шатунную шейку (всего %1).</translation>
    </message>
    <message>
        <source> + %1 overbalance</source>
        <comment>after the factor; negative numbers have their sign</comment>
        <translation> + перебаланс %1</translation>
    </message>
    <message>
        <source>%1 in each plane</source>
        <translation>%1 в каждой плоскости</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Деталь</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Плоскость</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Заключение</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Угол</translation>
    </message>
    <message>
        <source>Drilled from … to</source>
        <translation>Сверлят от … до</translation>
    </message>
    <message>
        <source>Readings of the balancing machine</source>
        <translation>Показания балансировочного станка</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Пуск</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Измерено</translation>
    </message>
    <message>
        <source>By G %1 of ISO 21940-11, %2 at %3.</source>
        <translation>По G %1 ИСО 21940-11, %2 при %3.</translation>
    </message>
    <message>
        <source>Half in each plane.</source>
        <translation>Половина на каждую плоскость.</translation>
    </message>
    <message>
        <source>Sum</source>
        <translation>Всего</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Исходно</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Пуск %1</translation>
    </message>
    <message>
        <source>After correction</source>
        <translation>После коррекции</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Отверстие</translation>
    </message>
    <message>
        <source>Depth, %1</source>
        <translation>Глубина, %1</translation>
    </message>
    <message>
        <source>Takes off, %1</source>
        <translation>Снимает, %1</translation>
    </message>
    <message>
        <source>On the crankpin.</source>
        <translation>На шейке.</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 при %2</translation>
    </message>
    <message>
        <source>Already drilled</source>
        <translation>Уже просверлено</translation>
    </message>
    <message>
        <source>Cylinders that share a crankpin: %1.</source>
        <translation>На одной шейке цилиндры: %1.</translation>
    </message>
    <message>
        <source>Mean bob weight %1</source>
        <translation>Средний балансировочный груз %1</translation>
    </message>
    <message>
        <source>, slugs of %1</source>
        <translation>, вставок %1</translation>
    </message>
    <message>
        <source>%1 (cylinders %2)</source>
        <translation>%1 (цилиндры %2)</translation>
    </message>
    <message>
        <source>After moving the sets as suggested: %1.</source>
        <translation>После предложенной перестановки: %1.</translation>
    </message>
    <message>
        <source>Sheet 5, %1</source>
        <translation>Лист 5, %1</translation>
    </message>
    <message>
        <source>Sheet 6, heavy metal</source>
        <translation>Лист 6, тяжёлый металл</translation>
    </message>
    <message>
        <source>Sheet 6, drills</source>
        <translation>Лист 6, свёрла</translation>
    </message>
    <message>
        <source>Reciprocating</source>
        <translation>Возвратно-поступательные</translation>
    </message>
    <message>
        <source>Rotating</source>
        <translation>Вращающиеся</translation>
    </message>
    <message>
        <source>slug ⌀ %1</source>
        <translation>вставка ⌀ %1</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>0°: %1.</source>
        <translation>0°: %1.</translation>
    </message>
    <message>
        <source>Job card: balancing</source>
        <translation>Карта работ: балансировка</translation>
    </message>
    <message>
        <source>Ravnoves %1 · ISO 21940-11</source>
        <translation>Ravnoves %1 · ISO 21940-11</translation>
    </message>
    <message>
        <source>Sheet 5: enter position and radius of both planes.</source>
        <translation>Лист 5: введите положение и радиус обеих плоскостей.</translation>
    </message>
    <message>
        <source>Shop limit for each plane, instead of a grade.</source>
        <translation>Предел мастерской для каждой плоскости, без класса.</translation>
    </message>
    <message>
        <source>Shared between the planes by the distances of the end bearings.</source>
        <translation>Поделён между плоскостями по расстояниям до крайних подшипников.</translation>
    </message>
    <message>
        <source>Shared between the planes by the centre of mass.</source>
        <translation>Поделён между плоскостями по центру масс.</translation>
    </message>
    <message>
        <source>Sheet 5, permissible residual</source>
        <translation>Лист 5, допустимый остаток</translation>
    </message>
    <message>
        <source>%1: enter %2 in %3, separated by semicolons: %4</source>
        <translation>%1: введите «%2» в %3, через точку с запятой, например %4</translation>
    </message>
    <message>
        <source>%1: enter %2. %3</source>
        <translation>%1: введите «%2». %3</translation>
    </message>
    <message>
        <source>Sheet 5, %1, %2: enter the angle.</source>
        <translation>Лист 5, %1, %2: введите угол.</translation>
    </message>
    <message>
        <source>Sheet 5, %1, %2: enter the unbalance.</source>
        <translation>Лист 5, %1, %2: введите дисбаланс.</translation>
    </message>
    <message>
        <source>Missing for the bob weight: %1</source>
        <translation>Для груза не хватает: %1</translation>
    </message>
    <message>
        <source>Balance factor %1 (theory: %2)</source>
        <translation>Коэффициент балансировки %1 (по теории %2)</translation>
    </message>
    <message>
        <source>Balance factor %1, by theory</source>
        <translation>Коэффициент балансировки %1, по теории</translation>
    </message>
    <message>
        <source>Permissible residual: %1, of %2 for the crankshaft.</source>
        <translation>Допустимый остаток: %1, из %2 для всего вала.</translation>
    </message>
    <message>
        <source>Permissible residual: %1.</source>
        <translation>Допустимый остаток: %1.</translation>
    </message>
    <message>
        <source>Not given, %1 is used: %2. Enter 0 if there is no such part.</source>
        <translation>Не задано, принято %1: %2. Если детали нет, введите 0.</translation>
    </message>
    <message>
        <source>%1: the drilled holes were planned from another reading.</source>
        <translation>%1: просверленные отверстия рассчитаны по другому показанию.</translation>
    </message>
    <message>
        <source>Readings: %1 and %2. “Measured” is the reading transferred to the planes.</source>
        <translation>Показания: %1 и %2. «Измерено» — показание, перенесённое в плоскости.</translation>
    </message>
    <message>
        <source>A slug is as long as its hole; its mass is given with its diameter. Secure it: a press fit alone does not withstand the force at service speed.</source>
        <translation>Длина вставки равна глубине отверстия; её масса указана рядом с диаметром. Закрепите её: одна посадка с натягом не удержит силу на рабочих оборотах.</translation>
    </message>
    <message>
        <source>Depths exclude the drill point; the rim is taken as flat.</source>
        <translation>Глубины — без конуса сверла; обод считается плоским.</translation>
    </message>
    <message>
        <source>Planned with a point angle of %1 and a crankshaft density of %2</source>
        <translation>Рассчитано: угол при вершине сверла %1, плотность вала %2</translation>
    </message>
    <message>
        <source>Weighed to %1, a bob weight is accurate to ±%2 (95 %).</source>
        <translation>При взвешивании до %1 балансировочный груз известен до ±%2 (95&#xa0;%).</translation>
    </message>
    <message>
        <source>Bob weight by crankpin, %1: %2.</source>
        <translation>Балансировочный груз по шейкам, %1: %2.</translation>
    </message>
    <message>
        <source>Each, %1</source>
        <translation>Каждый, %1</translation>
    </message>
    <message>
        <source>Multiplier</source>
        <translation>Множитель</translation>
    </message>
    <message>
        <source>Total, %1</source>
        <translation>Всего, %1</translation>
    </message>
    <message>
        <source>Heavy spot</source>
        <translation>Тяжёлое место</translation>
    </message>
    <message>
        <source>Mass at drilling radius</source>
        <translation>Масса на радиусе сверления</translation>
    </message>
    <message>
        <source>Taken off, %1</source>
        <translation>Снято, %1</translation>
    </message>
    <message>
        <source>Older holes</source>
        <translation>Прежние отверстия</translation>
    </message>
    <message>
        <source>After “Before”</source>
        <translation>После «Исходно»</translation>
    </message>
    <message>
        <source>After Run %1</source>
        <translation>После пуска %1</translation>
    </message>
    <message>
        <source>Angles are clockwise, seen from the front.</source>
        <translation>Углы — по часовой стрелке, если смотреть спереди.</translation>
    </message>
    <message>
        <source>Angles are counter-clockwise, seen from the front.</source>
        <translation>Углы — против часовой стрелки, если смотреть спереди.</translation>
    </message>
    <message>
        <source>Drill radially from the rim, towards the axis.</source>
        <translation>Сверлите радиально от обода, к оси.</translation>
    </message>
    <message>
        <source>Hole angles are where to drill: opposite the light spot that the machine shows.</source>
        <translation>Углы отверстий — те, под которыми сверлят: напротив лёгкого места, которое показывает станок.</translation>
    </message>
    <message>
        <source>Permissible residual</source>
        <translation>Допустимый остаток</translation>
    </message>
    <message>
        <source>Correction: measured → after correction</source>
        <translation>Коррекция: измерено → после коррекции</translation>
    </message>
    <message>
        <source>STOP: no bob weight yet</source>
        <translation>СТОП: балансировочного груза пока нет</translation>
    </message>
    <message>
        <source>Bob weight with the nearest option: %1</source>
        <translation>Балансировочный груз с ближайшим вариантом: %1</translation>
    </message>
    <message>
        <source>No bob weights are needed</source>
        <translation>Балансировочные грузы не нужны</translation>
    </message>
    <message>
        <source>The crankpins balance one another.</source>
        <translation>Шатунные шейки уравновешивают друг друга.</translation>
    </message>
    <message>
        <source>%1, crankpins split by %2</source>
        <translation>%1, шейки разведены на %2</translation>
    </message>
    <message>
        <source>Provisional: %1</source>
        <translation>Предварительно: %1</translation>
    </message>
    <message>
        <source>The crankpins balance one another. If you use bob weights: %1.</source>
        <translation>Шатунные шейки уравновешивают друг друга. Если используете балансировочные грузы: %1.</translation>
    </message>
    <message>
        <source>hole centre at R %1</source>
        <translation>центр отверстия на R %1</translation>
    </message>
    <message>
        <source>adds %1</source>
        <translation>добавляет %1</translation>
    </message>
    <message>
        <source>centrifugal force %1 at %2</source>
        <translation>центробежная сила %1 при %2</translation>
    </message>
    <message>
        <source>%1 (%2 at R %3)</source>
        <translation>%1 (%2 на R %3)</translation>
    </message>
    <message>
        <source>Hole angles are where to drill: at the heavy spot that the machine shows.</source>
        <translation>Углы отверстий — те, под которыми сверлят: у тяжёлого места, которое показывает станок.</translation>
    </message>
    <message>
        <source>Work at the listed angles: holes are opposite the light spot that the machine shows, slugs are at it.</source>
        <translation>Работайте под указанными углами: отверстия — напротив лёгкого места, которое показывает станок, вставки — у него.</translation>
    </message>
    <message>
        <source>Work at the listed angles: holes are at the heavy spot that the machine shows, slugs are opposite it.</source>
        <translation>Работайте под указанными углами: отверстия — у тяжёлого места, которое показывает станок, вставки — напротив него.</translation>
    </message>
</context>
<context>
    <name>Errors</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Для этого не хватает памяти.</translation>
    </message>
    <message>
        <source>The computation failed.</source>
        <translation>Вычисление не удалось.</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>строка %1</translation>
    </message>
    <message>
        <source>variant %1</source>
        <translation>вариант %1</translation>
    </message>
    <message>
        <source>a group of values</source>
        <translation>группа значений</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>список</translation>
    </message>
</context>
<context>
    <name>JobCard</name>
    <message>
        <source>Engine number</source>
        <translation>Номер двигателя</translation>
    </message>
    <message>
        <source>Crankshaft number</source>
        <translation>Номер коленчатого вала</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Дата</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Заказчик</translation>
    </message>
    <message>
        <source>Technician</source>
        <translation>Исполнитель</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Двигатель</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>вывод</translation>
    </message>
    <message>
        <source>other crankshaft</source>
        <translation>другой вал</translation>
    </message>
    <message>
        <source>works</source>
        <translation>годится</translation>
    </message>
    <message>
        <source>does not work</source>
        <translation>не годится</translation>
    </message>
    <message>
        <source>Plug</source>
        <translation>Заглушка</translation>
    </message>
    <message>
        <source>Piston set from</source>
        <translation>Поршень из цилиндра</translation>
    </message>
    <message>
        <source>Rod set from</source>
        <translation>Шатун из цилиндра</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Примечания</translation>
    </message>
    <message>
        <source>Technician, signature</source>
        <translation>Исполнитель, подпись</translation>
    </message>
    <message>
        <source>Inspector, signature</source>
        <translation>Контролёр, подпись</translation>
    </message>
    <message>
        <source>Masses of the parts by cylinder, %1</source>
        <translation>Массы деталей по цилиндрам, %1</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Страница %1 из %2</translation>
    </message>
    <message>
        <source>V-8 engine: %1</source>
        <translation>Двигатель V-8, %1</translation>
    </message>
    <message>
        <source>take off each, %1</source>
        <translation>облегчить каждую, %1</translation>
    </message>
    <message>
        <source>Result outdated: entries not accepted: %1</source>
        <translation>Результат устарел: недопустимые значения: %1</translation>
    </message>
    <message>
        <source>Not accepted, the previous value is used: %1</source>
        <translation>Не принято, используется прежнее значение: %1</translation>
    </message>
    <message>
        <source>No bob weight, holes or plug work are printed until these entries are corrected: %1</source>
        <translation>Груз, отверстия и работа с заглушками не печатаются, пока не исправлены эти значения: %1</translation>
    </message>
    <message>
        <source>Entries not accepted: %1</source>
        <translation>Значения не приняты: %1</translation>
    </message>
    <message>
        <source>Options by cost</source>
        <translation>Варианты по стоимости</translation>
    </message>
    <message>
        <source>remains, %1</source>
        <translation>остаток, %1</translation>
    </message>
    <message>
        <source>maximum each, %1</source>
        <translation>предел для одной, %1</translation>
    </message>
    <message>
        <source>works, shift included</source>
        <translation>годится, смещение учтено</translation>
    </message>
</context>
<context>
    <name>Matching</name>
    <message>
        <source>Throws from the front at %1.</source>
        <translation>Углы колен, считая спереди: %1.</translation>
    </message>
    <message>
        <source>as weighed</source>
        <translation>как взвешено</translation>
    </message>
    <message>
        <source>Force at %1</source>
        <translation>Сила при %1</translation>
    </message>
    <message>
        <source>Couple</source>
        <translation>Момент</translation>
    </message>
    <message>
        <source>Couple at %1</source>
        <translation>Момент при %1</translation>
    </message>
    <message>
        <source>At the ends, mean</source>
        <translation>На концах вала, среднее</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Цилиндр</translation>
    </message>
    <message>
        <source>Unbalance</source>
        <translation>Дисбаланс</translation>
    </message>
    <message>
        <source>Unbalance at the crank radius</source>
        <translation>Дисбаланс на радиусе кривошипа</translation>
    </message>
    <message>
        <source>Couple at the crank radius</source>
        <translation>Момент на радиусе кривошипа</translation>
    </message>
    <message>
        <source>Assemble by set numbers: the range of the crankpins is then %1.</source>
        <translation>Собирать по номерам комплектов: размах шеек тогда %1.</translation>
    </message>
    <message>
        <source>The parts are placed optimally: range of the crankpins %1.</source>
        <translation>Детали размещены наилучшим образом: размах шеек %1.</translation>
    </message>
    <message>
        <source>Parts not moved: range of the crankpins %1.</source>
        <translation>Детали на своих местах: размах шеек %1.</translation>
    </message>
    <message>
        <source>Range of the crankpins: %1 now, %2 after moving %3 more sets.</source>
        <translation>Размах шеек: сейчас %1, после перестановки ещё %3 комплектов — %2.</translation>
    </message>
    <message>
        <source>Range of the crankpins: %1 as weighed, %2 after moving %3 sets.</source>
        <translation>Размах шеек: %1 как взвешено, после перестановки комплектов (%3) — %2.</translation>
    </message>
    <message>
        <source>Too many combinations to try all: this is the best found.</source>
        <translation>Расстановок слишком много, чтобы перебрать все: это лучшая из найденных.</translation>
    </message>
    <message>
        <source>The couple is included; enter the cylinder spacing to see its value.</source>
        <translation>Момент учтён; введите шаг цилиндров, чтобы увидеть его величину.</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Разница</translation>
    </message>
    <message>
        <source>now</source>
        <translation>сейчас</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>предложено</translation>
    </message>
    <message>
        <source>Crankpins, range</source>
        <translation>Шейки, размах</translation>
    </message>
    <message>
        <source>Heaviest minus lightest crankpin, by bob weight</source>
        <translation>Самая тяжёлая шейка минус самая лёгкая, по балансировочному грузу</translation>
    </message>
    <message>
        <source>First-order unbalance due to deviations from the mean mass, maximum over a turn; the unbalance of the layout itself is not included</source>
        <translation>Дисбаланс первого порядка от отклонений масс от среднего, максимум за оборот; неуравновешенность самой схемы не входит</translation>
    </message>
    <message>
        <source>Couple along the crankshaft, about its middle</source>
        <translation>Момент вдоль вала, относительно его середины</translation>
    </message>
    <message>
        <source>RMS of force and couple over a turn, at both end cylinders; “Minimum shaking” minimises it</source>
        <translation>СКЗ силы и момента за оборот, по обоим крайним цилиндрам; его минимизирует цель «Минимальная тряска»</translation>
    </message>
    <message>
        <source>Dot: the part is not moved; number: its previous cylinder</source>
        <translation>Точка: деталь на месте; число: прежний цилиндр детали</translation>
    </message>
    <message>
        <source>Previous cylinder of the piston</source>
        <translation>Прежний цилиндр поршня</translation>
    </message>
    <message>
        <source>Previous cylinder of the rod</source>
        <translation>Прежний цилиндр шатуна</translation>
    </message>
    <message>
        <source>Matched parts: suggested, not yet applied</source>
        <translation>Подобранные детали: предложено, ещё не переставлены</translation>
    </message>
    <message>
        <source>Matched parts: applied, the masses are moved</source>
        <translation>Подобранные детали: переставлены</translation>
    </message>
    <message>
        <source>To match the lightest part, if required: take off, %1</source>
        <translation>До самой лёгкой, если нужно: снять, %1</translation>
    </message>
    <message>
        <source>To match the lightest part, only if moving is not enough: take off, %1</source>
        <translation>До самой лёгкой, только если перестановки мало: снять, %1</translation>
    </message>
    <message>
        <source>The bob weight is for the parts as weighed: weigh parts again after making them lighter.</source>
        <translation>Балансировочный груз рассчитан на взвешенные детали: облегчённую деталь взвесьте снова.</translation>
    </message>
    <message>
        <source>Part no.</source>
        <translation>Деталь №</translation>
    </message>
    <message>
        <source>Effect of the matching</source>
        <translation>Результат подбора</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>is required and missing</source>
        <translation>обязательно, но отсутствует</translation>
    </message>
    <message>
        <source>must be at most %1</source>
        <translation>должно быть не больше %1</translation>
    </message>
    <message>
        <source>must be a file name</source>
        <translation>должно быть именем файла</translation>
    </message>
    <message>
        <source>Gots, Klevtsov</source>
        <translation>Гоц, Клевцов</translation>
    </message>
    <message>
        <source>A. N. Gots, V. S. Klevtsov</source>
        <translation>А. Н. Гоц, В. С. Клевцов</translation>
    </message>
    <message>
        <source>Selection of the optimal scheme of stabilization of the one-cylinder engine</source>
        <translation>Выбор рациональной схемы уравновешивания одноцилиндрового двигателя</translation>
    </message>
    <message>
        <source>Zotov, Sviridov</source>
        <translation>Зотов, Свиридов</translation>
    </message>
    <message>
        <source>A. N. Zotov, A. S. Sviridov</source>
        <translation>А. Н. Зотов, А. С. Свиридов</translation>
    </message>
    <message>
        <source>Crank-and-rod mechanism with elastic hinges of given characteristics</source>
        <translation>Кривошипно-шатунный механизм с упругими шарнирами, имеющими заданные характеристики</translation>
    </message>
    <message>
        <source>Nazarov</source>
        <translation>Назаров</translation>
    </message>
    <message>
        <source>A. D. Nazarov</source>
        <translation>А. Д. Назаров</translation>
    </message>
    <message>
        <source>Compensating the total unbalanced mass of crank-gear parts of V-8 engines in manufacture and repair</source>
        <translation>Способ компенсации суммарной неуравновешенной массы деталей КШМ двигателей V-8 при их изготовлении и ремонте</translation>
    </message>
    <message>
        <source>Chainov, Vallejo Maldonado</source>
        <translation>Чайнов, Вальехо Мальдонадо</translation>
    </message>
    <message>
        <source>N. D. Chainov, P. R. Vallejo Maldonado</source>
        <translation>Н. Д. Чайнов, П. Р. Вальехо Мальдонадо</translation>
    </message>
    <message>
        <source>Balancing the moments of a VR5 engine taking into account a desaxial crank mechanism and cylinder camber angle</source>
        <translation>Уравновешивание моментов двигателя VR5 с учётом дезаксажа и угла развала цилиндров</translation>
    </message>
    <message>
        <source>%1, &quot;%2&quot;, %3, %4</source>
        <translation>%1, «%2», %3, %4</translation>
    </message>
    <message>
        <source>is nested more than %1 levels deep</source>
        <translation>вложено глубже %1 уровней</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>пусто</translation>
    </message>
    <message>
        <source>is not valid JSON</source>
        <translation>это не JSON</translation>
    </message>
    <message>
        <source>must be at most %1 (a newer program wrote this case; update to open it)</source>
        <translation>должно быть не больше %1 (задача записана более новой программой; обновите программу)</translation>
    </message>
    <message>
        <source>must be one of %1 (the nearest is %2)</source>
        <translation>допустимо одно из: %1 (ближайшее — %2)</translation>
    </message>
    <message>
        <source>must be one of %1</source>
        <translation>допустимо одно из: %1</translation>
    </message>
    <message>
        <source>must be an object</source>
        <translation>должно быть объектом</translation>
    </message>
    <message>
        <source>must be a number or %1</source>
        <translation>должно быть числом или %1</translation>
    </message>
    <message>
        <source>is required and missing (or %1)</source>
        <translation>обязательно, но отсутствует (или %1)</translation>
    </message>
    <message>
        <source>%1, got %2</source>
        <translation>%1, получено %2</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>строка %1</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>строка %1, столбец %2</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>должно быть числом</translation>
    </message>
    <message>
        <source>must be a list</source>
        <translation>должно быть списком</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>должно быть true или false</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>должно быть текстом</translation>
    </message>
    <message>
        <source>is not a known key; the nearest is %1</source>
        <translation>неизвестный ключ; ближайший — %1</translation>
    </message>
    <message>
        <source>is not a known key</source>
        <translation>неизвестный ключ</translation>
    </message>
    <message>
        <source>must be from %1 to %2</source>
        <translation>должно быть от %1 до %2</translation>
    </message>
    <message>
        <source>must be greater than %1 and at most %2</source>
        <translation>должно быть больше %1 и не больше %2</translation>
    </message>
    <message>
        <source>must be greater than %1</source>
        <translation>должно быть больше %1</translation>
    </message>
    <message>
        <source>must be at least %1</source>
        <translation>должно быть не меньше %1</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>должно быть конечным числом</translation>
    </message>
    <message>
        <source>must be a whole number from %1 to %2</source>
        <translation>должно быть целым числом от %1 до %2</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>не удалось записать: %1</translation>
    </message>
    <message>
        <source>must be a file, not a folder</source>
        <translation>должно быть файлом, а не папкой</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>не читается: %1</translation>
    </message>
    <message>
        <source>must be at most 64 MiB</source>
        <translation>должно быть не больше 64 МиБ</translation>
    </message>
    <message>
        <source>must not separate columns by commas and use decimal commas at once; separate the columns by semicolons</source>
        <translation>запятая не может и разделять столбцы, и отделять дробную часть; разделите столбцы точкой с запятой</translation>
    </message>
    <message>
        <source>must be text; this looks like a binary file</source>
        <translation>должен быть текст, а это похоже на двоичный файл</translation>
    </message>
    <message>
        <source>%1 columns</source>
        <translation>столбцов: %1</translation>
    </message>
    <message>
        <source>m</source>
        <translation>м</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>мм</translation>
    </message>
    <message>
        <source>µm</source>
        <translation>мкм</translation>
    </message>
    <message>
        <source>l</source>
        <translation>л</translation>
    </message>
    <message>
        <source>cm³</source>
        <translation>см³</translation>
    </message>
    <message>
        <source>kg</source>
        <translation>кг</translation>
    </message>
    <message>
        <source>g</source>
        <translation>г</translation>
    </message>
    <message>
        <source>kg·m</source>
        <translation>кг·м</translation>
    </message>
    <message>
        <source>g·mm</source>
        <translation>г·мм</translation>
    </message>
    <message>
        <source>kg·m²</source>
        <translation>кг·м²</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>кг/м³</translation>
    </message>
    <message>
        <source>N</source>
        <translation>Н</translation>
    </message>
    <message>
        <source>kN</source>
        <translation>кН</translation>
    </message>
    <message>
        <source>N·m</source>
        <translation>Н·м</translation>
    </message>
    <message>
        <source>N/m</source>
        <translation>Н/м</translation>
    </message>
    <message>
        <source>kN/m</source>
        <translation>кН/м</translation>
    </message>
    <message>
        <source>J</source>
        <translation>Дж</translation>
    </message>
    <message>
        <source>kW</source>
        <translation>кВт</translation>
    </message>
    <message>
        <source>Pa</source>
        <translation>Па</translation>
    </message>
    <message>
        <source>kPa</source>
        <translation>кПа</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>бар</translation>
    </message>
    <message>
        <source>MPa</source>
        <translation>МПа</translation>
    </message>
    <message>
        <source>GPa</source>
        <translation>ГПа</translation>
    </message>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>мм/с</translation>
    </message>
    <message>
        <source>m/s²</source>
        <translation>м/с²</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>рад</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>рад/с</translation>
    </message>
    <message>
        <source>min⁻¹</source>
        <translation>мин⁻¹</translation>
    </message>
    <message>
        <source>must be %1 or %2</source>
        <translation>должно быть %1 или %2</translation>
    </message>
    <message>
        <source>kN·m</source>
        <translation>кН·м</translation>
    </message>
    <message>
        <source>is given twice</source>
        <translation>задано дважды</translation>
    </message>
    <message>
        <source>is not in the list, which has %1 elements</source>
        <translation>нет в списке, в нём элементов: %1</translation>
    </message>
    <message>
        <source>must be a file, not a pipe or a device</source>
        <translation>должен быть файлом, а не каналом и не устройством</translation>
    </message>
    <message>
        <source>cm²</source>
        <translation>см²</translation>
    </message>
    <message>
        <source>must be a file in the folder of the case, unless --allow-files is given</source>
        <translation>должно быть файлом в папке задачи, если не задан --allow-files</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>не должно быть пустым</translation>
    </message>
    <message>
        <source>must differ from the names of the other variants</source>
        <translation>должно отличаться от имён других вариантов</translation>
    </message>
    <message>
        <source>is not a known key (a newer program may have written this case; update to open it)</source>
        <translation>неизвестный ключ (возможно, задачу записала более новая программа; обновите её, чтобы открыть)</translation>
    </message>
    <message>
        <source>must be a JSON pointer below the result, such as /optimum/range</source>
        <translation>должно быть указателем JSON внутри результата, например /optimum/range</translation>
    </message>
    <message>
        <source>must be a value that the result has</source>
        <translation>должно быть величиной, которая есть в результате</translation>
    </message>
    <message>
        <source>in</source>
        <translation>дюйм</translation>
    </message>
    <message>
        <source>mil</source>
        <translation>мил</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>фут</translation>
    </message>
    <message>
        <source>in²</source>
        <translation>дюйм²</translation>
    </message>
    <message>
        <source>in³</source>
        <translation>дюйм³</translation>
    </message>
    <message>
        <source>lb</source>
        <translation>фунт</translation>
    </message>
    <message>
        <source>oz</source>
        <translation>унц</translation>
    </message>
    <message>
        <source>oz·in</source>
        <translation>унц·дюйм</translation>
    </message>
    <message>
        <source>lb·ft²</source>
        <translation>фунт·фут²</translation>
    </message>
    <message>
        <source>lb·ft</source>
        <translation>фунт·фут</translation>
    </message>
    <message>
        <source>lbf</source>
        <translation>фунт-сила</translation>
    </message>
    <message>
        <source>lbf/in</source>
        <translation>фунт-с./дюйм</translation>
    </message>
    <message>
        <source>lb/ft³</source>
        <translation>фунт/фут³</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>см</translation>
    </message>
    <message>
        <source>s⁻¹</source>
        <translation>с⁻¹</translation>
    </message>
    <message>
        <source>g·mm²</source>
        <translation>г·мм²</translation>
    </message>
    <message>
        <source>g·in</source>
        <translation>г·дюйм</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>нет значения</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>нет такого файла или каталога</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>нет прав доступа</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>операция не разрешена</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>на диске нет места</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>исчерпана квота на диске</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>диск доступен только для чтения</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>это каталог</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>это не каталог</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>слишком длинное имя файла</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>слишком большой файл</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>устройство занято</translation>
    </message>
    <message>
        <source>Too many levels of symbolic links</source>
        <translation>слишком много вложенных ссылок</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>открыто слишком много файлов</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>ошибка ввода-вывода</translation>
    </message>
    <message>
        <source>Problemy mashinostroeniya i nadezhnosti mashin, no. 5</source>
        <translation>Проблемы машиностроения и надёжности машин, № 5</translation>
    </message>
    <message>
        <source>Izvestiya vysshikh uchebnykh zavedeniy. Mashinostroenie, no. 5</source>
        <translation>Известия высших учебных заведений. Машиностроение, № 5</translation>
    </message>
    <message>
        <source>pp. %1</source>
        <translation>с. %1</translation>
    </message>
    <message>
        <source>must be numbers with blanks or semicolons between them</source>
        <translation>должны быть числа через пробел или точку с запятой</translation>
    </message>
    <message>
        <source>must have the decimal sign of the numbers above: all points or all commas, and nothing between thousands</source>
        <translation>десятичный знак должен быть тем же, что у чисел выше: везде точка или везде запятая, и ничего между тысячами</translation>
    </message>
    <message>
        <source>must be the name of a variant</source>
        <translation>должно быть именем варианта</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Заключение</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Уровень</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Причина</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Примечание</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Примечания</translation>
    </message>
    <message>
        <source>Feasible</source>
        <translation>Осуществимо</translation>
    </message>
    <message>
        <source>must have a column with the heading %1</source>
        <translation>должен быть столбец с заголовком %1</translation>
    </message>
    <message>
        <source>must have a column of values: columns are numbered from 1</source>
        <translation>должен быть столбец значений: столбцы нумеруются с 1</translation>
    </message>
    <message>
        <source>must not contain the character NUL</source>
        <translation>не должно содержать символ NUL</translation>
    </message>
    <message>
        <source>must have at most %1 names</source>
        <translation>должно содержать не более %1 имён</translation>
    </message>
    <message>
        <source>contains a number that is too large for this program</source>
        <translation>содержит число, слишком большое для программы</translation>
    </message>
    <message>
        <source>must have at most %1 values</source>
        <translation>должно содержать не более %1 значений</translation>
    </message>
    <message>
        <source>must be left out if %1 is given</source>
        <translation>не указывается, если задано %1</translation>
    </message>
    <message>
        <source>is required and missing; found: %1</source>
        <translation>обязательно, но отсутствует; есть %1</translation>
    </message>
    <message>
        <source>is read-only and was not changed</source>
        <translation>только для чтения и не изменён</translation>
    </message>
    <message>
        <source>is a pipe without a reader</source>
        <translation>это канал без читателя</translation>
    </message>
    <message>
        <source>must have two columns, %1 and %2, or the case must name two of them in &quot;columns&quot;</source>
        <translation>должно быть два столбца, %1 и %2, или задача должна назвать два из них в &quot;columns&quot;</translation>
    </message>
    <message>
        <source>must have two columns, %1 and %2</source>
        <translation>должно быть два столбца: %1 и %2</translation>
    </message>
    <message>
        <source>must have at least %1 columns</source>
        <translation>должно быть не меньше %1 столбцов</translation>
    </message>
    <message>
        <source>must be unambiguous: its comma may divide thousands or be a decimal sign, as no other number of the column has one</source>
        <translation>должно быть однозначным: запятая может делить тысячи или отделять дробную часть, в других числах столбца её нет</translation>
    </message>
    <message>
        <source>Speed %1 is implausible: check it.</source>
        <translation>Частота %1 неправдоподобна: проверьте её.</translation>
    </message>
    <message>
        <source>Crank radius %1 is implausible: check it.</source>
        <translation>Радиус кривошипа %1 неправдоподобен: проверьте его.</translation>
    </message>
    <message>
        <source>Rod length %1 is implausible: check it.</source>
        <translation>Длина шатуна %1 неправдоподобна: проверьте её.</translation>
    </message>
    <message>
        <source>Crank radius %1 and rod %2 are implausible together: check their units, for example centimetres instead of millimetres.</source>
        <translation>Радиус кривошипа %1 и шатун %2 вместе неправдоподобны: проверьте единицы, например сантиметры вместо миллиметров.</translation>
    </message>
    <message>
        <source>Mass %1 and crank radius %2 are implausible together: check their units, for example grams instead of kilograms.</source>
        <translation>Масса %1 и радиус кривошипа %2 вместе неправдоподобны: проверьте единицы, например граммы вместо килограммов.</translation>
    </message>
    <message>
        <source>must be a known module</source>
        <translation>модуль неизвестен</translation>
    </message>
    <message>
        <source>is not a setting of this page; settings: kernel, sweep, value</source>
        <translation>не настройка этой страницы; настройки: kernel, sweep, value</translation>
    </message>
    <message>
        <source>needs more memory than available</source>
        <translation>требует больше памяти, чем доступно</translation>
    </message>
    <message>
        <source>must be a module of the window; the command line solves this case</source>
        <translation>должен быть модулем с окном; эту задачу решает командная строка</translation>
    </message>
    <message>
        <source>must be two numbers or one: enter %1 or %2</source>
        <translation>должно быть двумя числами или одним: введите %1 или %2</translation>
    </message>
    <message>
        <source>bore</source>
        <translation>диаметр цилиндра</translation>
    </message>
    <message>
        <source>crank radius</source>
        <translation>радиус кривошипа</translation>
    </message>
    <message>
        <source>rod length</source>
        <translation>длина шатуна</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>дезаксаж</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>частота вращения</translation>
    </message>
    <message>
        <source>reciprocating mass</source>
        <translation>возвратно-поступательная масса</translation>
    </message>
    <message>
        <source>%1, &quot;%2&quot;, %3 or later</source>
        <translation>%1, «%2», %3 или позже</translation>
    </message>
    <message>
        <source>rotating mass</source>
        <translation>вращающаяся масса</translation>
    </message>
    <message>
        <source>&amp;Name of the engine</source>
        <translation>&amp;Название двигателя</translation>
    </message>
    <message>
        <source>The journal finds the jobs of an engine by its name: “Copy as new job” takes engine and plugs from them.</source>
        <translation>По названию журнал находит работы двигателя: «Копировать как новую» берёт из них двигатель и заглушки.</translation>
    </message>
    <message>
        <source>Results use the previous value of each red field.</source>
        <translation>Результаты — по прежнему значению каждого красного поля.</translation>
    </message>
    <message>
        <source>none of them</source>
        <translation>ни одного</translation>
    </message>
    <message>
        <source>more than one of them</source>
        <translation>больше одного</translation>
    </message>
    <message>
        <source>must be %1 as in %2, or be left out</source>
        <translation>должно быть %1, как в %2, или отсутствовать</translation>
    </message>
    <message>
        <source>&amp;Speed n</source>
        <translation>&amp;Частота вращения n</translation>
    </message>
    <message>
        <source>&amp;Crank radius r</source>
        <translation>Радиус кр&amp;ивошипа r</translation>
    </message>
    <message>
        <source>&amp;Piston</source>
        <translation>Порше&amp;нь</translation>
    </message>
    <message>
        <source>Piston p&amp;in</source>
        <translation>Поршневой пале&amp;ц</translation>
    </message>
    <message>
        <source>Rin&amp;gs</source>
        <translation>&amp;Кольца</translation>
    </message>
    <message>
        <source>Rod, small-&amp;end share</source>
        <translation>Доля шат&amp;уна у пальца</translation>
    </message>
    <message>
        <source>Whole rod with she&amp;lls</source>
        <translation>Шатун с вклад&amp;ышами</translation>
    </message>
    <message>
        <source>any</source>
        <translation>не задано</translation>
    </message>
    <message>
        <source>Coun&amp;terweight radius ρ₁</source>
        <translation>Радиус про&amp;тивовеса ρ₁</translation>
    </message>
    <message>
        <source>Counterweight &amp;mass m₁</source>
        <translation>&amp;Масса противовеса m₁</translation>
    </message>
    <message>
        <source>Centre &amp;distance l</source>
        <translation>Ме&amp;жосевое расстояние l</translation>
    </message>
    <message>
        <source>straight lines</source>
        <translation>отрезки прямых</translation>
    </message>
    <message>
        <source>periodic cubic spline</source>
        <translation>кубический сплайн</translation>
    </message>
    <message>
        <source>I&amp;nterpolation</source>
        <translation>Интерпол&amp;яция</translation>
    </message>
    <message>
        <source>Rod lengt&amp;h L</source>
        <translation>Д&amp;лина шатуна L</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>авто</translation>
    </message>
    <message>
        <source>Share &amp;κ</source>
        <translation>Доля &amp;κ</translation>
    </message>
    <message>
        <source>Crank swing radi&amp;us</source>
        <translation>Радиус вращения криво&amp;шипа</translation>
    </message>
    <message>
        <source>Shaft swin&amp;g radius</source>
        <translation>Радиус &amp;оборота вала</translation>
    </message>
    <message>
        <source>Gear tip r&amp;adius</source>
        <translation>Радиус вершин зу&amp;бьев</translation>
    </message>
    <message>
        <source>Housing &amp;wall and gap</source>
        <translation>Ст&amp;енка и зазор</translation>
    </message>
    <message>
        <source>Teeth of each of the two equal gears.</source>
        <translation>Зубья каждой из двух одинаковых шестерён.</translation>
    </message>
    <message>
        <source>Circumferential play at the pitch circle, whose radius is l/2.</source>
        <translation>Окружной зазор на делительной окружности радиусом l/2.</translation>
    </message>
    <message>
        <source>&amp;Bore</source>
        <translation>Диаметр &amp;цилиндра</translation>
    </message>
    <message>
        <source>O&amp;ffset e</source>
        <translation>Дезакса&amp;ж e</translation>
    </message>
    <message>
        <source>Crankcase &amp;pressure</source>
        <translation>Давление в &amp;картере</translation>
    </message>
    <message>
        <source>Absolute pressure under the piston, p₀.</source>
        <translation>Абсолютное давление под поршнем, p₀.</translation>
    </message>
    <message>
        <source>Compression &amp;ratio ε</source>
        <translation>Степень сжатия &amp;ε</translation>
    </message>
    <message>
        <source>&amp;Intake pressure</source>
        <translation>Давление вп&amp;уска</translation>
    </message>
    <message>
        <source>Absolute, constant over intake.</source>
        <translation>Абсолютное, постоянное на впуске.</translation>
    </message>
    <message>
        <source>E&amp;xhaust pressure</source>
        <translation>Давление в&amp;ыпуска</translation>
    </message>
    <message>
        <source>Absolute, constant over exhaust.</source>
        <translation>Абсолютное, постоянное на выпуске.</translation>
    </message>
    <message>
        <source>Exponent, &amp;compression</source>
        <translation>Показатель сж&amp;атия</translation>
    </message>
    <message>
        <source>Polytropic exponent until combustion begins; about 1.32 to 1.38.</source>
        <translation>Показатель политропы до начала сгорания, около 1,32–1,38.</translation>
    </message>
    <message>
        <source>Exponent, ex&amp;pansion</source>
        <translation>Показатель рас&amp;ширения</translation>
    </message>
    <message>
        <source>Polytropic exponent of combustion and expansion; about 1.22 to 1.32.</source>
        <translation>Показатель политропы сгорания и расширения, около 1,22–1,32.</translation>
    </message>
    <message>
        <source>&amp;Heat</source>
        <translation>&amp;Теплота</translation>
    </message>
    <message>
        <source>Heat released per cycle; instead of the IMEP.</source>
        <translation>Теплота, выделенная за цикл; вместо среднего индикаторного давления.</translation>
    </message>
    <message>
        <source>I&amp;MEP</source>
        <translation>Ср. инд. давл&amp;ение pᵢ</translation>
    </message>
    <message>
        <source>&amp;Start of combustion</source>
        <translation>&amp;Начало сгорания</translation>
    </message>
    <message>
        <source>Crank angle; 360° is the firing top dead centre.</source>
        <translation>Угол поворота кривошипа; 360° — верхняя мёртвая точка сгорания.</translation>
    </message>
    <message>
        <source>&amp;Duration</source>
        <translation>Д&amp;лительность</translation>
    </message>
    <message>
        <source>Crank angle from the start to the end of heat release.</source>
        <translation>Угол поворота от начала до конца тепловыделения.</translation>
    </message>
    <message>
        <source>&amp;Wiebe exponent m</source>
        <translation>Показатель Ви&amp;бе m</translation>
    </message>
    <message>
        <source>Form exponent of Wiebe&apos;s law; 0.5 to 1.5 for diesels, 2 to 4 for petrol engines.</source>
        <translation>Показатель характера сгорания по Вибе; 0,5–1,5 для дизелей, 2–4 для бензиновых двигателей.</translation>
    </message>
    <message>
        <source>&amp;Diameter D</source>
        <translation>&amp;Диаметр D</translation>
    </message>
    <message>
        <source>Depth &amp;h</source>
        <translation>&amp;Глубина h</translation>
    </message>
    <message>
        <source>&amp;Length b</source>
        <translation>Длин&amp;а b</translation>
    </message>
    <message>
        <source>Densit&amp;y</source>
        <translation>Плотно&amp;сть</translation>
    </message>
    <message>
        <source>must add up to more than 0 and to a finite mass</source>
        <translation>в сумме должна получиться конечная масса больше 0</translation>
    </message>
    <message>
        <source>both</source>
        <translation>оба</translation>
    </message>
    <message>
        <source>neither</source>
        <translation>ни одного</translation>
    </message>
    <message>
        <source>must end the combustion before the bottom dead centre at %1</source>
        <translation>сгорание должно закончиться до нижней мёртвой точки, %1</translation>
    </message>
    <message>
        <source>must give a displacement from 1e-6 cm³ to 1e9 cm³</source>
        <translation>должно давать рабочий объём от 1e-6 см³ до 1e9 см³</translation>
    </message>
    <message>
        <source>must be less than the teeth, which must be from %1 to %2</source>
        <translation>должно быть меньше числа зубьев, а оно — от %1 до %2</translation>
    </message>
    <message>
        <source>must be less than the diameter, %1</source>
        <translation>должно быть меньше диаметра, %1</translation>
    </message>
    <message>
        <source>The bar is too thin: over a length of %1 its diameter must be at least %2; with this diameter the relieved length must be at least %3.</source>
        <translation>Пруток слишком тонок: при длине %1 нужен диаметр не меньше %2, при этом диаметре — длина лыски не меньше %3.</translation>
    </message>
    <message>
        <source>More than half of the bar is milled away: the depth %1 gives the same unbalance and a stiffer shaft.</source>
        <translation>Снято больше половины прутка: глубина %1 даёт тот же дисбаланс и более жёсткий вал.</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>момент</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>давление</translation>
    </message>
    <message>
        <source>crank angle</source>
        <translation>угол кривошипа</translation>
    </message>
    <message>
        <source>must not repeat the angle of the row before, %1</source>
        <translation>не должно повторять угол предыдущей строки, %1</translation>
    </message>
    <message>
        <source>must be greater than the angle of the row before, %1</source>
        <translation>должно быть больше угла предыдущей строки, %1</translation>
    </message>
    <message>
        <source>must equal the first %1, %2, since the cycle repeats</source>
        <translation>последнее значение (%1) должно равняться первому, %2: цикл повторяется</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>строк: %1</translation>
    </message>
    <message>
        <source>separated by semicolons</source>
        <translation>разделитель — точка с запятой</translation>
    </message>
    <message>
        <source>separated by commas</source>
        <translation>разделитель — запятая</translation>
    </message>
    <message>
        <source>separated by tabs</source>
        <translation>разделитель — табуляция</translation>
    </message>
    <message>
        <source>separated by blanks</source>
        <translation>разделитель — пробел</translation>
    </message>
    <message>
        <source>decimal comma</source>
        <translation>десятичная запятая</translation>
    </message>
    <message>
        <source>angles in radians</source>
        <translation>углы в радианах</translation>
    </message>
    <message>
        <source>angles in degrees</source>
        <translation>углы в градусах</translation>
    </message>
    <message>
        <source>with a header</source>
        <translation>с заголовком</translation>
    </message>
    <message>
        <source>pressure in %1</source>
        <translation>давление: %1</translation>
    </message>
    <message>
        <source>end joined to the start</source>
        <translation>конец сведён с началом</translation>
    </message>
    <message>
        <source>the %1 table must have at least 3 rows</source>
        <translation>в таблице (%1) должно быть хотя бы 3 строки</translation>
    </message>
    <message>
        <source>the angles must span 720° (or 360°, or 4π or 2π in radians), the last row repeating the first</source>
        <translation>углы должны охватывать 720° (или 360°, в радианах 4π или 2π), последняя строка повторяет первую</translation>
    </message>
    <message>
        <source>must be at least %1 more than the angle of the row before, %2</source>
        <translation>должно быть больше угла предыдущей строки, %2, не меньше чем на %1</translation>
    </message>
    <message>
        <source>swing radius of the shaft</source>
        <translation>радиус вращения вала</translation>
    </message>
    <message>
        <source>swing radius of the crank</source>
        <translation>радиус вращения кривошипа</translation>
    </message>
    <message>
        <source>width of the rod</source>
        <translation>ширина шатуна</translation>
    </message>
    <message>
        <source>wall of the cylinder</source>
        <translation>стенка цилиндра</translation>
    </message>
    <message>
        <source>Sizes not given are assumed: %1.</source>
        <translation>Незаданные размеры приняты: %1.</translation>
    </message>
    <message>
        <source>Instead of the speed.</source>
        <translation>Вместо частоты вращения.</translation>
    </message>
    <message>
        <source>Reciprocating mass of the cylinder as one number.</source>
        <translation>Возвратно-поступательная масса цилиндра одним числом.</translation>
    </message>
    <message>
        <source>From the crank axis to the shaft, measured from the cylinder axis in the direction of rotation.</source>
        <translation>От оси коленчатого вала к балансирному, от оси цилиндра по направлению вращения.</translation>
    </message>
    <message>
        <source>Stro&amp;kes</source>
        <translation>Так&amp;тность</translation>
    </message>
    <message>
        <source>Step of the curves and of the sweep over α.</source>
        <translation>Шаг кривых и вариации по α.</translation>
    </message>
    <message>
        <source>Sizes of the front view.</source>
        <translation>Размеры вида спереди.</translation>
    </message>
    <message>
        <source>Cylinder &amp;top</source>
        <translation>Верх ц&amp;илиндра</translation>
    </message>
    <message>
        <source>Cylinder bott&amp;om</source>
        <translation>Низ ци&amp;линдра</translation>
    </message>
    <message>
        <source>C&amp;ylinder wall</source>
        <translation>Стенка &amp;цилиндра</translation>
    </message>
    <message>
        <source>Rod widt&amp;h</source>
        <translation>Ширина &amp;шатуна</translation>
    </message>
    <message>
        <source>The pair of gears that drives the shaft.</source>
        <translation>Пара шестерён, вращающая вал.</translation>
    </message>
    <message>
        <source>Rows of one cycle: the crank angles, ascending.</source>
        <translation>Строки одного цикла: углы поворота по возрастанию.</translation>
    </message>
    <message>
        <source>A file beside the case with two columns: crank angle, and torque (in pressure: cylinder pressure). Several cycles are averaged.</source>
        <translation>Файл рядом с задачей из двух столбцов: угол поворота и момент (в pressure — давление в цилиндре). Несколько циклов усредняются.</translation>
    </message>
    <message>
        <source>Gas torque from a measured cylinder pressure.</source>
        <translation>Момент газовых сил по измеренному давлению в цилиндре.</translation>
    </message>
    <message>
        <source>Gas torque of a computed cycle.</source>
        <translation>Момент газовых сил рассчитанного цикла.</translation>
    </message>
    <message>
        <source>Ports ope&amp;n</source>
        <translation>Окна открываю&amp;тся</translation>
    </message>
    <message>
        <source>Inertia &amp;J</source>
        <translation>Инерция &amp;J</translation>
    </message>
    <message>
        <source>Fl&amp;uctuation δ</source>
        <translation>Нера&amp;вномерность δ</translation>
    </message>
    <message>
        <source>A band of speeds to study.</source>
        <translation>Диапазон частот вращения для исследования.</translation>
    </message>
    <message>
        <source>Prints range and RMS over angle and speed too.</source>
        <translation>Печатать также размах и СКЗ по углу и частоте.</translation>
    </message>
    <message>
        <source>A bar with a segment milled away in place of counterweights.</source>
        <translation>Вал с выфрезерованным сегментом вместо противовесов.</translation>
    </message>
    <message>
        <source>must be less than the angle of the bottom dead centre, %1</source>
        <translation>должно быть меньше угла нижней мёртвой точки, %1</translation>
    </message>
    <message>
        <source>must end the combustion before the ports open at %1</source>
        <translation>должно заканчивать сгорание до открытия окон при %1</translation>
    </message>
    <message>
        <source>must be after the ports have closed, %1</source>
        <translation>должно быть после закрытия окон, %1</translation>
    </message>
    <message>
        <source>must be %1, since the pressure trace spans %2</source>
        <translation>должно быть %1: измеренное давление охватывает %2</translation>
    </message>
    <message>
        <source>must be %1, since the torque table spans %2</source>
        <translation>должно быть %1: таблица момента охватывает %2</translation>
    </message>
    <message>
        <source>360°, the cycle of a two-stroke engine</source>
        <translation>360°, цикл двухтактного двигателя</translation>
    </message>
    <message>
        <source>must span 720°, or 360° for a two-stroke engine, the last row repeating the first</source>
        <translation>должны охватывать 720° или, для двухтактного двигателя, 360°; последняя строка повторяет первую</translation>
    </message>
    <message>
        <source>two-stroke</source>
        <translation>двухтактный</translation>
    </message>
    <message>
        <source>four-stroke</source>
        <translation>четырёхтактный</translation>
    </message>
    <message>
        <source>α from</source>
        <translation>α от</translation>
    </message>
    <message>
        <source>α to</source>
        <translation>α до</translation>
    </message>
    <message>
        <source>Teeth &amp;z</source>
        <translation>Зубья &amp;z</translation>
    </message>
    <message>
        <source>Teeth out, &amp;k</source>
        <translation>Сдвиг в зубьях, &amp;k</translation>
    </message>
    <message>
        <source>Back&amp;lash</source>
        <translation>&amp;Боковой зазор</translation>
    </message>
    <message>
        <source>&amp;Band from</source>
        <translation>&amp;Диапазон от</translation>
    </message>
    <message>
        <source>Band &amp;to</source>
        <translation>Диапазон д&amp;о</translation>
    </message>
    <message>
        <source>must be at most the mass of the whole rod, %1</source>
        <translation>должно быть не больше массы всего шатуна, %1</translation>
    </message>
    <message>
        <source>torque in %1</source>
        <translation>момент в %1</translation>
    </message>
    <message>
        <source>Torque of the engine</source>
        <translation>Крутящий момент двигателя</translation>
    </message>
    <message>
        <source>gas torque and inertia torque; p pressure in the cylinder, p₀ in the crankcase, A piston area, s distance of the piston pin from the crank axis, ′ by φ</source>
        <translation>момент газов и момент инерции; p — давление в цилиндре, p₀ — в картере, A — площадь поршня, s — расстояние поршневого пальца от оси вала, ′ — по φ</translation>
    </message>
    <message>
        <source>Piston pin</source>
        <translation>Поршневой палец</translation>
    </message>
    <message>
        <source>L length of the rod, e offset of the cylinder, θ angle of the crank from the cylinder&apos;s direction</source>
        <translation>L — длина шатуна, e — дезаксаж, θ — угол кривошипа от направления цилиндра</translation>
    </message>
    <message>
        <source>Shaft fitted k teeth out</source>
        <translation>Вал собран со сдвигом на k зубьев</translation>
    </message>
    <message>
        <source>Play of the gears</source>
        <translation>Зазор в зацеплении</translation>
    </message>
    <message>
        <source>b play at the pitch circle</source>
        <translation>b — зазор по делительной окружности</translation>
    </message>
    <message>
        <source>Reciprocating mass</source>
        <translation>Поступательная масса</translation>
    </message>
    <message>
        <source>piston, pin, rings and the small-end share of the rod</source>
        <translation>поршень, палец, кольца и доля шатуна у верхней головки</translation>
    </message>
    <message>
        <source>First-order inertia force</source>
        <translation>Сила инерции первого порядка</translation>
    </message>
    <message>
        <source>r crank radius, ω angular speed, φ crank angle from top dead centre</source>
        <translation>r — радиус кривошипа, ω — угловая скорость, φ — угол кривошипа от верхней мёртвой точки</translation>
    </message>
    <message>
        <source>Counterweight</source>
        <translation>Противовес</translation>
    </message>
    <message>
        <source>ρ₁ radius of its centre of mass</source>
        <translation>ρ₁ — радиус его центра масс</translation>
    </message>
    <message>
        <source>Force of a counterweight</source>
        <translation>Сила противовеса</translation>
    </message>
    <message>
        <source>Tipping moment</source>
        <translation>Опрокидывающий момент</translation>
    </message>
    <message>
        <source>reaction to the torque Mᵢ of the engine and, for an offset cylinder, to the angular momentum of its reciprocating masses</source>
        <translation>реакция на крутящий момент Mᵢ двигателя, а у дезаксиального цилиндра — и на момент импульса поступательных масс</translation>
    </message>
    <message>
        <source>Moment of the shaft</source>
        <translation>Момент вала</translation>
    </message>
    <message>
        <source>l distance and α angle of the shaft&apos;s axis from the crank axis; for an offset cylinder δ is the lag of the counterweights</source>
        <translation>l — расстояние и α — угол оси вала от оси коленчатого вала; у дезаксиального цилиндра δ — отставание противовесов</translation>
    </message>
    <message>
        <source>Moment on the mounts</source>
        <translation>Момент на опорах</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Размах</translation>
    </message>
    <message>
        <source>RMS about the mean</source>
        <translation>СКЗ относительно среднего</translation>
    </message>
    <message>
        <source>Φ length of the cycle, Mₘ its mean</source>
        <translation>Φ — длина цикла, Mₘ — среднее за цикл</translation>
    </message>
    <message>
        <source>c₁ and s₁ coefficients of cos φ and sin φ in Mᵤₚ; x = l sin α, y = l cos α</source>
        <translation>c₁ и s₁ — коэффициенты при cos φ и sin φ в Mᵤₚ; x = l sin α, y = l cos α</translation>
    </message>
    <message>
        <source>Crank alone, without a shaft</source>
        <translation>Один кривошип, без вала</translation>
    </message>
    <message>
        <source>half-axes of the ellipse of the first-order force, along and across the cylinder; κ balanced share</source>
        <translation>полуоси эллипса силы первого порядка, вдоль и поперёк цилиндра; κ — уравновешенная доля</translation>
    </message>
    <message>
        <source>Swing circle of the shaft, assumed</source>
        <translation>Окружность вращения вала, принятая</translation>
    </message>
    <message>
        <source>Flywheel</source>
        <translation>Маховик</translation>
    </message>
    <message>
        <source>ΔE excess work between the extremes of E, J moment of inertia, δ fluctuation of the speed, Mᵢₘ mean torque</source>
        <translation>ΔE — избыточная работа между крайними значениями E, J — момент инерции, δ — неравномерность хода, Mᵢₘ — средний момент</translation>
    </message>
    <message>
        <source>Shaft with a relieved middle</source>
        <translation>Вал с лыской в средней части</translation>
    </message>
    <message>
        <source>ρ density, b length of the relief, A the segment milled away, y from the axis</source>
        <translation>ρ — плотность, b — длина лыски, A — снятый сегмент, y — от оси</translation>
    </message>
    <message>
        <source>The engine block is rigid, and the speed within a cycle is constant.</source>
        <translation>Блок двигателя жёсткий, скорость в пределах цикла постоянна.</translation>
    </message>
    <message>
        <source>of the exact s″: −r₁ cos(θ − δ) is its first order; ω angular speed, θ − φ the same at every angle</source>
        <translation>из точной s″: −r₁ cos(θ − δ) — её первый порядок; ω — угловая скорость, θ − φ одинакова при всех углах</translation>
    </message>
    <message>
        <source>a half disc of steel, ρ = 7850 kg/m³, as long as the bore B, with the unbalance m₁ρ₁</source>
        <translation>стальной полудиск, ρ = 7850 кг/м³, длиной в диаметр цилиндра B с дисбалансом m₁ρ₁</translation>
    </message>
    <message>
        <source>by equation (1), m₁ = mⱼ r / (2 ρ₁); a number overrides it</source>
        <translation>по формуле (1), m₁ = mⱼ r / (2 ρ₁); число её заменяет</translation>
    </message>
    <message>
        <source>r / 0.3</source>
        <translation>r / 0,3</translation>
    </message>
    <message>
        <source>Top of the engine above the crank axis.</source>
        <translation>Верх двигателя над осью коленчатого вала.</translation>
    </message>
    <message>
        <source>the piston pin at top dead centre plus half the bore</source>
        <translation>верхняя мёртвая точка пальца плюс половина диаметра</translation>
    </message>
    <message>
        <source>Lower end of the cylinder above the crank axis.</source>
        <translation>Нижний конец цилиндра над осью коленчатого вала.</translation>
    </message>
    <message>
        <source>0.06 of the bore</source>
        <translation>0,06 диаметра</translation>
    </message>
    <message>
        <source>r / 2</source>
        <translation>r / 2</translation>
    </message>
    <message>
        <source>Circle swept by crank and counterweight.</source>
        <translation>Окружность, описываемая кривошипом и противовесом.</translation>
    </message>
    <message>
        <source>Circle swept by the balance shaft.</source>
        <translation>Окружность, описываемая балансирным валом.</translation>
    </message>
    <message>
        <source>Tip circle of each of the two gears.</source>
        <translation>Окружность вершин каждой из двух шестерён.</translation>
    </message>
    <message>
        <source>l/2, the pitch circle</source>
        <translation>l/2, делительная окружность</translation>
    </message>
    <message>
        <source>the stroke, 2 r</source>
        <translation>ход поршня, 2 r</translation>
    </message>
    <message>
        <source>&amp;Shift of the angles</source>
        <translation>С&amp;двиг углов</translation>
    </message>
    <message>
        <source>Added around every circle, and above and beside the cylinder.</source>
        <translation>Добавляются вокруг каждой окружности, а также над цилиндром и по бокам от него.</translation>
    </message>
    <message>
        <source>Does not fit: at this α the shaft meets the rod.</source>
        <translation>Не помещается: при этом α вал задевает шатун.</translation>
    </message>
    <message>
        <source>Does not fit: at this α the shaft meets the cylinder.</source>
        <translation>Не помещается: при этом α вал задевает цилиндр.</translation>
    </message>
    <message>
        <source>Relieved shaft: %1</source>
        <translation>Вал с лыской: %1</translation>
    </message>
    <message>
        <source>range %1 smaller</source>
        <translation>размах меньше на %1</translation>
    </message>
    <message>
        <source>range %1 larger</source>
        <translation>размах больше на %1</translation>
    </message>
    <message>
        <source>RMS %1 smaller</source>
        <translation>СКЗ меньше на %1</translation>
    </message>
    <message>
        <source>RMS %1 larger</source>
        <translation>СКЗ больше на %1</translation>
    </message>
    <message>
        <source>Angular speed ω</source>
        <translation>Угловая скорость ω</translation>
    </message>
    <message>
        <source>Reciprocating mass mⱼ</source>
        <translation>Поступательная масса mⱼ</translation>
    </message>
    <message>
        <source>Inertia force Pⱼ₁, maximum</source>
        <translation>Сила инерции Pⱼ₁, максимум</translation>
    </message>
    <message>
        <source>Counterweight mass m₁</source>
        <translation>Масса противовеса m₁</translation>
    </message>
    <message>
        <source>Counterweight force P₁</source>
        <translation>Сила противовеса P₁</translation>
    </message>
    <message>
        <source>m₁ ρ₁ ω².</source>
        <translation>m₁ ρ₁ ω².</translation>
    </message>
    <message>
        <source>α</source>
        <translation>α</translation>
    </message>
    <message>
        <source>Mᵤₚ</source>
        <translation>Mᵤₚ</translation>
    </message>
    <message>
        <source>Mₛ</source>
        <translation>Mₛ</translation>
    </message>
    <message>
        <source>Mᵤₚₛ</source>
        <translation>Mᵤₚₛ</translation>
    </message>
    <message>
        <source>Change vs. no shaft</source>
        <translation>Изменение относительно схемы без вала</translation>
    </message>
    <message>
        <source>range</source>
        <translation>размах</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>СКЗ</translation>
    </message>
    <message>
        <source>Mean of table rows (paper)</source>
        <translation>Среднее по строкам таблицы (статья)</translation>
    </message>
    <message>
        <source>Mₛ, 25 rows</source>
        <translation>Mₛ, 25 строк</translation>
    </message>
    <message>
        <source>Mᵤₚ, table rows</source>
        <translation>Mᵤₚ, строки таблицы</translation>
    </message>
    <message>
        <source>Mᵤₚₛ, table rows</source>
        <translation>Mᵤₚₛ, строки таблицы</translation>
    </message>
    <message>
        <source>Best α</source>
        <translation>Лучший α</translation>
    </message>
    <message>
        <source>Best feasible α</source>
        <translation>Лучший допустимый α</translation>
    </message>
    <message>
        <source>minimum range</source>
        <translation>минимальный размах</translation>
    </message>
    <message>
        <source>minimum RMS</source>
        <translation>минимальное СКЗ</translation>
    </message>
    <message>
        <source>Feasible positions</source>
        <translation>Допустимые положения</translation>
    </message>
    <message>
        <source>Feasible α</source>
        <translation>Допустимые α</translation>
    </message>
    <message>
        <source>Feasible at this α</source>
        <translation>Допустимо при этом α</translation>
    </message>
    <message>
        <source>First order of Mᵤₚ</source>
        <translation>Первый порядок Mᵤₚ</translation>
    </message>
    <message>
        <source>share of the variance</source>
        <translation>доля дисперсии</translation>
    </message>
    <message>
        <source>Crank angle at TDC</source>
        <translation>Угол кривошипа в ВМТ</translation>
    </message>
    <message>
        <source>Lag of the counterweights</source>
        <translation>Отставание противовесов</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Габарит</translation>
    </message>
    <message>
        <source>Check of the inertia torque</source>
        <translation>Проверка момента сил инерции</translation>
    </message>
    <message>
        <source>Order spectrum</source>
        <translation>Спектр порядков</translation>
    </message>
    <message>
        <source>Indicated cycle</source>
        <translation>Индикаторный цикл</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Кривые</translation>
    </message>
    <message>
        <source>Sweep over α</source>
        <translation>Вариация α</translation>
    </message>
    <message>
        <source>Clearances</source>
        <translation>Зазоры</translation>
    </message>
    <message>
        <source>Without shaft</source>
        <translation>Без вала</translation>
    </message>
    <message>
        <source>Optimum ignoring clearance</source>
        <translation>Оптимум без учёта зазоров</translation>
    </message>
    <message>
        <source>Best feasible place</source>
        <translation>Лучшее допустимое положение</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>Шестерни</translation>
    </message>
    <message>
        <source>Relieved shaft</source>
        <translation>Вал с лыской</translation>
    </message>
    <message>
        <source>Speed band</source>
        <translation>Диапазон частот</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>среднее</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>максимум</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>минимум</translation>
    </message>
    <message>
        <source>Maximum minus minimum over the cycle.</source>
        <translation>Максимум минус минимум за цикл.</translation>
    </message>
    <message>
        <source>About the mean, over the cycle.</source>
        <translation>Относительно среднего, за цикл.</translation>
    </message>
    <message>
        <source>φ of the maximum</source>
        <translation>φ максимума</translation>
    </message>
    <message>
        <source>φ of the minimum</source>
        <translation>φ минимума</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>амплитуда</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>фаза</translation>
    </message>
    <message>
        <source>width</source>
        <translation>ширина</translation>
    </message>
    <message>
        <source>height</source>
        <translation>высота</translation>
    </message>
    <message>
        <source>to the crank</source>
        <translation>до кривошипа</translation>
    </message>
    <message>
        <source>to the cylinder</source>
        <translation>до цилиндра</translation>
    </message>
    <message>
        <source>to the rod</source>
        <translation>до шатуна</translation>
    </message>
    <message>
        <source>minimum allowed</source>
        <translation>минимально допустимый</translation>
    </message>
    <message>
        <source>cylinder bore</source>
        <translation>диаметр цилиндра</translation>
    </message>
    <message>
        <source>cylinder wall</source>
        <translation>стенка цилиндра</translation>
    </message>
    <message>
        <source>bottom of the cylinder</source>
        <translation>низ цилиндра</translation>
    </message>
    <message>
        <source>top of the cylinder</source>
        <translation>верх цилиндра</translation>
    </message>
    <message>
        <source>tip radius of the gear</source>
        <translation>радиус вершин шестерни</translation>
    </message>
    <message>
        <source>Pareto-optimal</source>
        <translation>Оптимально по Парето</translation>
    </message>
    <message>
        <source>m r² ω² fitted</source>
        <translation>подобранное m r² ω²</translation>
    </message>
    <message>
        <source>m r² ω² entered</source>
        <translation>введённое m r² ω²</translation>
    </message>
    <message>
        <source>λ fitted</source>
        <translation>подобранная λ</translation>
    </message>
    <message>
        <source>consistent</source>
        <translation>согласуется</translation>
    </message>
    <message>
        <source>residual RMS</source>
        <translation>остаточное СКЗ</translation>
    </message>
    <message>
        <source>speed that fits</source>
        <translation>подходящая частота вращения</translation>
    </message>
    <message>
        <source>mass that fits</source>
        <translation>подходящая масса</translation>
    </message>
    <message>
        <source>λ is given</source>
        <translation>λ задана</translation>
    </message>
    <message>
        <source>order</source>
        <translation>порядок</translation>
    </message>
    <message>
        <source>Mᵤₚ, amplitude</source>
        <translation>Mᵤₚ, амплитуда</translation>
    </message>
    <message>
        <source>Mᵤₚ, phase</source>
        <translation>Mᵤₚ, фаза</translation>
    </message>
    <message>
        <source>Mᵤₚₛ, amplitude</source>
        <translation>Mᵤₚₛ, амплитуда</translation>
    </message>
    <message>
        <source>Mᵤₚₛ, phase</source>
        <translation>Mᵤₚₛ, фаза</translation>
    </message>
    <message>
        <source>maximum energy</source>
        <translation>максимум энергии</translation>
    </message>
    <message>
        <source>minimum energy</source>
        <translation>минимум энергии</translation>
    </message>
    <message>
        <source>displacement</source>
        <translation>рабочий объём</translation>
    </message>
    <message>
        <source>clearance volume</source>
        <translation>объём камеры сгорания</translation>
    </message>
    <message>
        <source>mean torque</source>
        <translation>средний крутящий момент</translation>
    </message>
    <message>
        <source>peak pressure</source>
        <translation>максимальное давление</translation>
    </message>
    <message>
        <source>φ of the peak pressure</source>
        <translation>φ максимального давления</translation>
    </message>
    <message>
        <source>Crank angle φ</source>
        <translation>Угол кривошипа φ</translation>
    </message>
    <message>
        <source>excess energy</source>
        <translation>избыточная энергия</translation>
    </message>
    <message>
        <source>gas torque</source>
        <translation>момент сил газов</translation>
    </message>
    <message>
        <source>inertia torque</source>
        <translation>момент сил инерции</translation>
    </message>
    <message>
        <source>moment of the offset</source>
        <translation>момент от дезаксажа</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>объём</translation>
    </message>
    <message>
        <source>mean of Mₛ</source>
        <translation>среднее Mₛ</translation>
    </message>
    <message>
        <source>mean of Mᵤₚₛ</source>
        <translation>среднее Mᵤₚₛ</translation>
    </message>
    <message>
        <source>mean of 25 rows of Mₛ</source>
        <translation>среднее по 25 строкам Mₛ</translation>
    </message>
    <message>
        <source>mean of table rows of Mᵤₚₛ</source>
        <translation>среднее по строкам таблицы Mᵤₚₛ</translation>
    </message>
    <message>
        <source>share balanced on the crank</source>
        <translation>доля, уравновешенная на коленчатом валу</translation>
    </message>
    <message>
        <source>unbalance of the crank&apos;s counterweight</source>
        <translation>дисбаланс противовеса коленчатого вала</translation>
    </message>
    <message>
        <source>centre distance l</source>
        <translation>межосевое расстояние l</translation>
    </message>
    <message>
        <source>certified gap</source>
        <translation>доказанная погрешность</translation>
    </message>
    <message>
        <source>Pareto-optimal places</source>
        <translation>Положения, оптимальные по Парето</translation>
    </message>
    <message>
        <source>certified gap of the places</source>
        <translation>доказанная погрешность положений</translation>
    </message>
    <message>
        <source>size</source>
        <translation>габарит</translation>
    </message>
    <message>
        <source>phase error</source>
        <translation>ошибка фазы</translation>
    </message>
    <message>
        <source>residual force</source>
        <translation>остаточная сила</translation>
    </message>
    <message>
        <source>play</source>
        <translation>боковой зазор</translation>
    </message>
    <message>
        <source>force from the play</source>
        <translation>сила от зазора</translation>
    </message>
    <message>
        <source>minimum range over the play</source>
        <translation>минимальный размах в пределах зазора</translation>
    </message>
    <message>
        <source>maximum range over the play</source>
        <translation>максимальный размах в пределах зазора</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>диаметр</translation>
    </message>
    <message>
        <source>depth of the relief</source>
        <translation>глубина лыски</translation>
    </message>
    <message>
        <source>length of the relief</source>
        <translation>длина лыски</translation>
    </message>
    <message>
        <source>width of the flat</source>
        <translation>ширина лыски</translation>
    </message>
    <message>
        <source>remaining mass</source>
        <translation>оставшаяся масса</translation>
    </message>
    <message>
        <source>range without shaft</source>
        <translation>размах без вала</translation>
    </message>
    <message>
        <source>RMS without shaft</source>
        <translation>СКЗ без вала</translation>
    </message>
    <message>
        <source>α of the minimum range</source>
        <translation>α минимального размаха</translation>
    </message>
    <message>
        <source>α of the minimum RMS</source>
        <translation>α минимального СКЗ</translation>
    </message>
    <message>
        <source>Best compromise</source>
        <translation>Лучший компромисс</translation>
    </message>
    <message>
        <source>Best feasible compromise</source>
        <translation>Лучший допустимый компромисс</translation>
    </message>
    <message>
        <source>range, relative</source>
        <translation>относительный размах</translation>
    </message>
    <message>
        <source>RMS, relative</source>
        <translation>относительное СКЗ</translation>
    </message>
    <message>
        <source>over its value without shaft</source>
        <translation>отношение к значению без вала</translation>
    </message>
    <message>
        <source>worst speed</source>
        <translation>худшая частота вращения</translation>
    </message>
    <message>
        <source>Map over speed and α</source>
        <translation>Карта по частоте вращения и α</translation>
    </message>
    <message>
        <source>Does not fit at any α. %1</source>
        <translation>Не помещается ни при каком α. %1</translation>
    </message>
    <message>
        <source>The cylinder and its rod, for every source of torque and for the front view.</source>
        <translation>Цилиндр и шатун, для любого источника момента и для вида спереди.</translation>
    </message>
    <message>
        <source>is required with a pressure trace or a computed cycle, and missing</source>
        <translation>нужно для индикаторной диаграммы и расчёта цикла, но отсутствует</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Столбцы</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Единица в файле</translation>
    </message>
    <message>
        <source>Unit of the values in the file: N·m, kN·m, lbf·ft or lbf·in; of pressures bar, kPa, MPa, psi, mbar or Pa.</source>
        <translation>Единица значений в файле: N·m, kN·m, lbf·ft или lbf·in; для давления bar, kPa, MPa, psi, mbar или Pa.</translation>
    </message>
    <message>
        <source>the unit in the heading, else N·m or bar</source>
        <translation>единица из заголовка, иначе Н·м или бар</translation>
    </message>
    <message>
        <source>Gauge pressure</source>
        <translation>Избыточное давление</translation>
    </message>
    <message>
        <source>True for pressures above atmospheric: 1.01325 bar is added. False for absolute pressures.</source>
        <translation>True — давление сверх атмосферного: прибавляется 1,01325 бар. False — абсолютное давление.</translation>
    </message>
    <message>
        <source>must be two numbers from 1 or two headings: of the crank angle and of the value</source>
        <translation>должно быть два номера от 1 или два заголовка: угла поворота и значения</translation>
    </message>
    <message>
        <source>mean of %1 cycles</source>
        <translation>среднее по %1 циклам</translation>
    </message>
    <message>
        <source>%1 at the end left out</source>
        <translation>%1 в конце не учтены</translation>
    </message>
    <message>
        <source>gauge pressure in %1</source>
        <translation>избыточное давление в %1</translation>
    </message>
    <message>
        <source>The dead centre is at %1 ± %2 of the trace: shift the angles by %3.</source>
        <translation>Мёртвая точка на %1 ± %2 диаграммы: сдвиньте углы на %3.</translation>
    </message>
    <message>
        <source>At every angle the shaft&apos;s swing circle (radius %1, clearance %2) meets the cylinder or the rod.</source>
        <translation>При любом угле окружность вала (радиус %1, зазор %2) задевает цилиндр или шатун.</translation>
    </message>
    <message>
        <source>At the centre distance %1 no angle clears cylinder and rod within the limits: %2.</source>
        <translation>При межосевом расстоянии %1 нет угла, при котором вал не задевает цилиндр и шатун в пределах: %2.</translation>
    </message>
    <message>
        <source>must be at least %1, the value of the cycle without heat</source>
        <translation>должно быть не меньше %1, значения цикла без теплоты</translation>
    </message>
    <message>
        <source>The dead centre may be at %1 ± %2 of the trace, a shift of %3; the compression line is not more precise.</source>
        <translation>Мёртвая точка, возможно, на %1 ± %2 диаграммы, сдвиг %3: точнее линия сжатия её не показывает.</translation>
    </message>
    <message>
        <source>lower end of the cylinder</source>
        <translation>нижний конец цилиндра</translation>
    </message>
    <message>
        <source>must have one of: %1 with %2, %3, %4, %5</source>
        <translation>должно содержать одно из: %1 с %2, %3, %4, %5</translation>
    </message>
    <message>
        <source>Distance between the centres of the rod&apos;s eyes. Clearance, the check of the torque and a computed torque use it.</source>
        <translation>Расстояние между центрами головок шатуна. Используется для зазоров, проверки момента и расчётного момента.</translation>
    </message>
    <message>
        <source>Distance of the cylinder axis from the crank axis, positive on the side to which the crankpin moves first. φ starts at the true top dead centre.</source>
        <translation>Расстояние оси цилиндра от оси коленчатого вала, положительное с той стороны, куда сначала идёт шатунная шейка. φ отсчитывается от истинной верхней мёртвой точки.</translation>
    </message>
    <message>
        <source>Parts of the reciprocating mass by name, for example piston, pin, rings, rod_small_end.</source>
        <translation>Части возвратно-поступательной массы по именам, например piston, pin, rings, rod_small_end.</translation>
    </message>
    <message>
        <source>Part of mⱼ r balanced on the crank alone, without a shaft. The force then describes an ellipse: a line at 0 and 1, a circle at ½.</source>
        <translation>Часть mⱼ r, уравновешенная на самом коленчатом валу, без балансирного. Сила тогда описывает эллипс: отрезок при 0 и 1, окружность при ½.</translation>
    </message>
    <message>
        <source>the piston pin at bottom dead centre minus 0.3 of the bore</source>
        <translation>нижняя мёртвая точка пальца минус 0,3 диаметра</translation>
    </message>
    <message>
        <source>Thickness of the cylinder wall; the shaft must clear it.</source>
        <translation>Толщина стенки цилиндра; вал не должен её задевать.</translation>
    </message>
    <message>
        <source>Width of the rod in the front view, including its ends; the shaft must clear the rod.</source>
        <translation>Ширина шатуна на виде спереди, включая головки; вал не должен задевать шатун.</translation>
    </message>
    <message>
        <source>Clearance to sha&amp;ft</source>
        <translation>&amp;Зазор до вала</translation>
    </message>
    <message>
        <source>Minimum clearance of the shaft&apos;s swing circle to crank, rod and cylinder.</source>
        <translation>Минимальный зазор окружности вала до кривошипа, шатуна и цилиндра.</translation>
    </message>
    <message>
        <source>r plus half the rod&apos;s width, at least the shaft&apos;s default</source>
        <translation>r плюс половина ширины шатуна, не меньше принятого для вала</translation>
    </message>
    <message>
        <source>the bar of the relieved shaft, else a steel half disc as long as the bore with the unbalance m₁ ρ₁</source>
        <translation>пруток вала с лыской, иначе стальной полудиск длиной с диаметр цилиндра с дисбалансом m₁ ρ₁</translation>
    </message>
    <message>
        <source>Limits on the place of the shaft&apos;s axis, in addition to the clearance.</source>
        <translation>Ограничения на место оси вала, помимо зазоров.</translation>
    </message>
    <message>
        <source>Minimum l</source>
        <translation>Минимум l</translation>
    </message>
    <message>
        <source>Minimum distance between crank axis and shaft axis.</source>
        <translation>Минимальное расстояние между осью кривошипа и осью вала.</translation>
    </message>
    <message>
        <source>Maximum l</source>
        <translation>Максимум l</translation>
    </message>
    <message>
        <source>Maximum distance between crank axis and shaft axis.</source>
        <translation>Максимальное расстояние между осью кривошипа и осью вала.</translation>
    </message>
    <message>
        <source>First angle of the shaft, in the direction of rotation.</source>
        <translation>Первый угол вала, по направлению вращения.</translation>
    </message>
    <message>
        <source>0 if the other end is given</source>
        <translation>0, если задан другой конец</translation>
    </message>
    <message>
        <source>Last angle of the shaft; across 0° it is less than the first.</source>
        <translation>Последний угол вала; через 0° он меньше первого.</translation>
    </message>
    <message>
        <source>360° if the other end is given</source>
        <translation>360°, если задан другой конец</translation>
    </message>
    <message>
        <source>Minimum x</source>
        <translation>Минимум x</translation>
    </message>
    <message>
        <source>The shaft axis must be to the right of this line, x from the crank axis. For a wall: add swing radius and clearance.</source>
        <translation>Ось вала должна быть правее этой линии, x от оси кривошипа. Для стенки: прибавьте радиус окружности вала и зазор.</translation>
    </message>
    <message>
        <source>Maximum x</source>
        <translation>Максимум x</translation>
    </message>
    <message>
        <source>The shaft axis must be to the left of this line.</source>
        <translation>Ось вала должна быть левее этой линии.</translation>
    </message>
    <message>
        <source>Minimum y</source>
        <translation>Минимум y</translation>
    </message>
    <message>
        <source>The shaft axis must be above this line, y from the crank axis.</source>
        <translation>Ось вала должна быть выше этой линии, y от оси кривошипа.</translation>
    </message>
    <message>
        <source>Maximum y</source>
        <translation>Максимум y</translation>
    </message>
    <message>
        <source>The shaft axis must be below this line.</source>
        <translation>Ось вала должна быть ниже этой линии.</translation>
    </message>
    <message>
        <source>The shaft is assembled k teeth ahead: a phase error of 360° k / z.</source>
        <translation>Вал собран со сдвигом на k зубьев вперёд: ошибка фазы 360° k / z.</translation>
    </message>
    <message>
        <source>Source of the engine torque: crank_angle_deg with torque_Nm, csv, pressure, or cycle.</source>
        <translation>Источник крутящего момента: crank_angle_deg с torque_Nm, csv, pressure или cycle.</translation>
    </message>
    <message>
        <source>Torque at these angles; the last value equals the first.</source>
        <translation>Момент при этих углах; последнее значение равно первому.</translation>
    </message>
    <message>
        <source>Checksum</source>
        <translation>Контрольная сумма</translation>
    </message>
    <message>
        <source>SHA-256 of the file when the case was made; a note reports a change.</source>
        <translation>SHA-256 файла на момент создания задачи; об изменении сообщает примечание.</translation>
    </message>
    <message>
        <source>Columns of crank angle and value: numbers from 1, or headings; required for more than two columns. Angle 0: equal steps over one cycle.</source>
        <translation>Столбцы угла и значения: номера от 1 или заголовки; нужны, если столбцов больше двух. Угол 0: равные шаги по одному циклу.</translation>
    </message>
    <message>
        <source>by the heading, else absolute</source>
        <translation>по заголовку, иначе абсолютное</translation>
    </message>
    <message>
        <source>Added to the crank angles of the trace; 360° if the trace starts at the firing dead centre.</source>
        <translation>Прибавляется к углам диаграммы; 360°, если она отсчитана от мёртвой точки сгорания.</translation>
    </message>
    <message>
        <source>Maximum over minimum volume.</source>
        <translation>Отношение максимального объёма к минимальному.</translation>
    </message>
    <message>
        <source>Indicated mean effective pressure; the heat follows.</source>
        <translation>Среднее индикаторное давление; теплота следует из него.</translation>
    </message>
    <message>
        <source>Crank angle after top dead centre at which the exhaust opens (two-stroke). It closes at the same piston position.</source>
        <translation>Угол после верхней мёртвой точки, при котором открывается выпуск (двухтактный). Закрывается он при том же положении поршня.</translation>
    </message>
    <message>
        <source>Flywheel: moment of inertia J, or coefficient of fluctuation δ.</source>
        <translation>Маховик: момент инерции J или коэффициент неравномерности δ.</translation>
    </message>
    <message>
        <source>Moment of inertia of flywheel, crank and all parts that turn with them. The coefficient of fluctuation follows.</source>
        <translation>Момент инерции маховика, коленчатого вала и всего, что вращается с ними. Из него следует коэффициент неравномерности.</translation>
    </message>
    <message>
        <source>Required (maximum − minimum) / mean speed; the moment of inertia follows. About 1/20 for pumps, 1/100 for generators.</source>
        <translation>Требуемое отношение (максимум − минимум) / средняя частота; из него следует момент инерции. Около 1/20 для насосов, 1/100 для генераторов.</translation>
    </message>
    <message>
        <source>Minimum speed of the band.</source>
        <translation>Минимальная частота диапазона.</translation>
    </message>
    <message>
        <source>Maximum speed of the band.</source>
        <translation>Максимальная частота диапазона.</translation>
    </message>
    <message>
        <source>Number of speeds, including both ends.</source>
        <translation>Число частот, включая концы.</translation>
    </message>
    <message>
        <source>Diameter of the round bar; also the swing circle of the shaft.</source>
        <translation>Диаметр круглого прутка; он же — окружность вала.</translation>
    </message>
    <message>
        <source>Depth of the milled segment, from the bar&apos;s surface.</source>
        <translation>Глубина снятого сегмента, от поверхности прутка.</translation>
    </message>
    <message>
        <source>Length of the milled segment.</source>
        <translation>Длина снятого сегмента.</translation>
    </message>
    <message>
        <source>Density of the bar. Steel 7850, cast iron 7200, tungsten alloy 17500.</source>
        <translation>Плотность прутка. Сталь 7850, чугун 7200, вольфрамовый сплав 17500.</translation>
    </message>
    <message>
        <source>z teeth of each gear; moment as at α + δ; ΔF residual first-order force</source>
        <translation>z — число зубьев каждой шестерни; момент как при α + δ; ΔF — остаточная сила первого порядка</translation>
    </message>
    <message>
        <source>of the continuous cycle</source>
        <translation>непрерывного цикла</translation>
    </message>
    <message>
        <source>Place of the minimum RMS</source>
        <translation>Место минимального СКЗ</translation>
    </message>
    <message>
        <source>Second-order forces (mⱼ r ω² λ cos 2φ) are not included in the moment on the mounts.</source>
        <translation>Силы второго порядка (mⱼ r ω² λ cos 2φ) в момент на опорах не входят.</translation>
    </message>
    <message>
        <source>The rotating part of rod and crank is balanced by the crank&apos;s own counterweights.</source>
        <translation>Вращающиеся части шатуна и кривошипа уравновешены собственными противовесами коленчатого вала.</translation>
    </message>
    <message>
        <source>Over the speed band the gas torque is constant: its change with speed is not known.</source>
        <translation>В диапазоне частот момент газов постоянен: как он меняется с частотой, неизвестно.</translation>
    </message>
    <message>
        <source>The play of the gears allows any shaft angle within it; the motion is not computed.</source>
        <translation>Зазор в зацеплении допускает любой угол вала в своих пределах; движение не вычисляется.</translation>
    </message>
    <message>
        <source>Parts that overlap in the front view may be one behind another.</source>
        <translation>Детали, которые перекрываются на виде спереди, могут быть одна за другой.</translation>
    </message>
    <message>
        <source>The torque during gas exchange does not resemble an inertia torque, so masses and speed cannot be checked.</source>
        <translation>Момент при газообмене не похож на инерционный, поэтому массы и частоту проверить нельзя.</translation>
    </message>
    <message>
        <source>A two-stroke engine has no stroke with a small gas torque, so masses and speed cannot be checked.</source>
        <translation>У двухтактного двигателя нет такта с малым газовым моментом, поэтому массы и частоту проверить нельзя.</translation>
    </message>
    <message>
        <source>Masses and speed cannot be checked, because the fitted r/L = %1 is at the limit of the search: enter the rod length.</source>
        <translation>Массы и частоту проверить нельзя, так как подобранное r/L = %1 — на границе поиска: введите длину шатуна.</translation>
    </message>
    <message>
        <source>Torque and rod do not match, so the best angles are not meaningful: r/L is %1 in the torque, %2 by the input; the torque fits a rod length of %3.</source>
        <translation>Момент и шатун не соответствуют друг другу, и лучшие углы не имеют смысла: r/L в моменте %1, по данным %2; моменту отвечает длина шатуна %3.</translation>
    </message>
    <message>
        <source>mⱼ r² ω² is %1 in the torque (r/L = %2), %3 by the input; the torque fits %4 or %5.</source>
        <translation>mⱼ r² ω² в моменте %1 (r/L = %2), по данным %3; моменту отвечает %4 или %5.</translation>
    </message>
    <message>
        <source>Torque and masses do not match, so the best angles are not meaningful.</source>
        <translation>Момент и массы не соответствуют друг другу, и лучшие углы не имеют смысла.</translation>
    </message>
    <message>
        <source>Torque and masses differ by %1: the torque fits %2 or %3.</source>
        <translation>Момент и массы расходятся на %1: моменту отвечает %2 или %3.</translation>
    </message>
    <message>
        <source>Torque and masses differ by %1; the uncertainty of the check is %2.</source>
        <translation>Момент и массы расходятся на %1; погрешность проверки %2.</translation>
    </message>
    <message>
        <source>The torque is computed from the masses and the speed: no check is necessary.</source>
        <translation>Момент вычислен по массам и частоте: проверка не нужна.</translation>
    </message>
    <message>
        <source>must have either %1 or %2</source>
        <translation>должно содержать либо %1, либо %2</translation>
    </message>
    <message>
        <source>%1 has changed since this case was made: import it again to accept the change, or restore the old file.</source>
        <translation>%1 изменился после создания задачи: импортируйте его снова, чтобы принять изменение, или верните прежний файл.</translation>
    </message>
    <message>
        <source>The uncertain dead centre of the trace is not included: give %1 a tolerance of ± %2.</source>
        <translation>Неточность мёртвой точки диаграммы не учтена: введите допуск ± %2 для %1.</translation>
    </message>
    <message>
        <source>must be at least the minimum speed of the band, %1</source>
        <translation>должно быть не меньше минимальной частоты диапазона, %1</translation>
    </message>
    <message>
        <source>The shaft has no moment: its angle has no effect.</source>
        <translation>Вал не создаёт момента: его угол не влияет.</translation>
    </message>
    <message>
        <source>The angle of the shaft does not affect the range.</source>
        <translation>Угол вала не влияет на размах.</translation>
    </message>
    <message>
        <source>The range is the same at least from %1 to %2.</source>
        <translation>Размах одинаков по крайней мере от %1 до %2.</translation>
    </message>
    <message>
        <source>The tipping moment has no first order: the angle of the shaft does not affect the RMS.</source>
        <translation>В опрокидывающем моменте нет первого порядка: угол вала не влияет на СКЗ.</translation>
    </message>
    <message>
        <source>An unused torque source had the bore %1: enter it at the cylinder, for all sources, if it is correct.</source>
        <translation>В неиспользуемом источнике момента был диаметр цилиндра %1: если он верен, введите его у цилиндра, для всех источников.</translation>
    </message>
    <message>
        <source>The shaft has no moment: its place has no effect.</source>
        <translation>Вал не создаёт момента: его место не влияет.</translation>
    </message>
    <message>
        <source>The tipping moment is constant: a shaft away from the crank axis only adds to it.</source>
        <translation>Опрокидывающий момент постоянен: любой вал в стороне от оси кривошипа лишь добавляет к нему.</translation>
    </message>
    <message>
        <source>must have two of %1, %2 and %3</source>
        <translation>должно содержать два из трёх: %1, %2, %3</translation>
    </message>
    <message>
        <source>No unbalance is required: no relief.</source>
        <translation>Дисбаланс не нужен: лыски нет.</translation>
    </message>
    <message>
        <source>No shaft of these sizes has the required unbalance.</source>
        <translation>Ни один вал таких размеров не даёт нужного дисбаланса.</translation>
    </message>
    <message>
        <source>These sizes give %1 % of the required unbalance.</source>
        <translation>Эти размеры дают %1&#xa0;% нужного дисбаланса.</translation>
    </message>
    <message>
        <source>no drawing: %1</source>
        <translation>чертежа нет: %1</translation>
    </message>
    <message>
        <source>Range and size</source>
        <translation>Размах и габарит</translation>
    </message>
    <message>
        <source>Does not fit: at this α the shaft is outside the limits.</source>
        <translation>Не помещается: при этом α вал выходит за заданные пределы.</translation>
    </message>
    <message>
        <source>The torque is constant: no shaft required.</source>
        <translation>Крутящий момент постоянен: вал не нужен.</translation>
    </message>
    <message>
        <source>Torque and rod do not match.</source>
        <translation>Момент и шатун не соответствуют друг другу.</translation>
    </message>
    <message>
        <source>Torque and masses do not match: the torque fits %1 or %2.</source>
        <translation>Момент и массы не соответствуют друг другу: моменту отвечает %1 или %2.</translation>
    </message>
    <message>
        <source>No place within the limits clears crank, cylinder and rod with the gears in mesh.</source>
        <translation>В заданных пределах нет места, где вал не задевает кривошип, цилиндр и шатун, а шестерни в зацеплении.</translation>
    </message>
    <message>
        <source>The shaft&apos;s swing circle (radius %1, clearance %2) meets the crank: centre distance %4, minimum %3.</source>
        <translation>Окружность вала (радиус %1, зазор %2) задевает кривошип: межосевое расстояние %4, минимум %3.</translation>
    </message>
    <message>
        <source>The shaft&apos;s swing circle (radius %1, clearance %2) meets the cylinder.</source>
        <translation>Окружность вала (радиус %1, зазор %2) задевает цилиндр.</translation>
    </message>
    <message>
        <source>The shaft&apos;s swing circle (radius %1, clearance %2) meets the rod.</source>
        <translation>Окружность вала (радиус %1, зазор %2) задевает шатун.</translation>
    </message>
    <message>
        <source>The gears do not mesh: with a tip radius of %1 the centre distance must be %2 to %3, not %4.</source>
        <translation>Шестерни не в зацеплении: при радиусе вершин %1 межосевое расстояние должно быть от %2 до %3, а не %4.</translation>
    </message>
    <message>
        <source>Centre distance %2 is below the minimum of %1.</source>
        <translation>Межосевое расстояние %2 меньше минимума %1.</translation>
    </message>
    <message>
        <source>Centre distance %2 is above the maximum of %1.</source>
        <translation>Межосевое расстояние %2 больше максимума %1.</translation>
    </message>
    <message>
        <source>The place is outside the limits.</source>
        <translation>Место вне заданных пределов.</translation>
    </message>
    <message>
        <source>The bar (radius %1) does not fit in the swing circle (radius %2).</source>
        <translation>Пруток (радиус %1) не помещается в окружности вала (радиус %2).</translation>
    </message>
    <message>
        <source>Not used, since bending of the relieved shaft is no longer computed: elastic modulus, bearing span, allowable stress, deflection, critical-speed ratio, bearing load.</source>
        <translation>Не используются, так как изгиб вала с лыской больше не вычисляется: модуль упругости, пролёт, допускаемое напряжение, прогиб, отношение к критической частоте, нагрузка подшипника.</translation>
    </message>
    <message>
        <source>The counterweight balances %1 % of the first-order inertia force; equation (1) requires %2.</source>
        <translation>Заданный противовес уравновешивает %1&#xa0;% силы инерции первого порядка; по формуле (1) нужно %2.</translation>
    </message>
    <message>
        <source>Offset cylinder: at the top dead centre (φ = 0) the crank is %1 from the cylinder&apos;s direction; both counterweights lag by %2.</source>
        <translation>Дезаксаж: в верхней мёртвой точке (φ = 0) кривошип под углом %1 к направлению цилиндра; оба противовеса отстают на %2.</translation>
    </message>
    <message>
        <source>No feasible position: %1</source>
        <translation>Допустимых положений нет: %1</translation>
    </message>
    <message>
        <source>The torque does not match masses and speed, so other speeds cannot be computed. %1</source>
        <translation>Момент не соответствует массам и частоте, поэтому другие частоты вычислить нельзя. %1</translation>
    </message>
    <message>
        <source>pressure assumed in %1, without a known unit in the heading</source>
        <translation>давление принято в %1, известной единицы в заголовке нет</translation>
    </message>
    <message>
        <source>torque assumed in %1, without a known unit in the heading</source>
        <translation>момент принят в %1, известной единицы в заголовке нет</translation>
    </message>
    <message>
        <source>%1; for gauge pressure set &quot;gauge&quot;: true</source>
        <translation>%1; для избыточного давления задайте &quot;gauge&quot;: true</translation>
    </message>
    <message>
        <source>a cycle must have at most %1 rows: use larger steps</source>
        <translation>в цикле должно быть не больше %1 строк: возьмите больший шаг</translation>
    </message>
    <message>
        <source>must have rows of numbers</source>
        <translation>должно содержать строки чисел</translation>
    </message>
    <message>
        <source>The file has no crank angles: equal steps over one cycle are assumed.</source>
        <translation>В файле нет углов поворота: приняты равные шаги по одному циклу.</translation>
    </message>
    <message>
        <source>The column of the crank angle is uncertain; column %1 is proposed.</source>
        <translation>Столбец угла поворота неоднозначен; предложен столбец %1.</translation>
    </message>
    <message>
        <source>The minimum pressure is %1 %2: gauge pressure?</source>
        <translation>Минимальное давление %1&#xa0;%2: это избыточное давление?</translation>
    </message>
    <message>
        <source>must have as many numbers as %1, %2</source>
        <translation>чисел должно быть столько же, сколько в «%1», %2</translation>
    </message>
    <message>
        <source>must have at least 3 numbers</source>
        <translation>должно быть хотя бы 3 числа</translation>
    </message>
    <message>
        <source>must have at most %1 numbers: average the cycles, or use larger steps</source>
        <translation>должно быть не больше %1 чисел: усредните циклы или возьмите больший шаг</translation>
    </message>
    <message>
        <source>The peak of the pressure trace is at %1, near the gas-exchange dead centre. The firing dead centre is at 360°: shift the trace by one turn.</source>
        <translation>Пик индикаторной диаграммы при&#xa0;%1, у мёртвой точки газообмена. Мёртвая точка сгорания при 360°: сдвиньте диаграмму на оборот.</translation>
    </message>
    <message>
        <source>The peak of the pressure trace is %1 after the firing dead centre at %2; usual: 5° before to 45° after. Check the phase of the crank angles.</source>
        <translation>Пик индикаторной диаграммы на %1 после мёртвой точки сгорания при&#xa0;%2; обычно от 5° до неё до 45° после. Проверьте фазу углов.</translation>
    </message>
    <message>
        <source>The trace looks like gauge pressure: %1 bar at the bottom dead centre before compression. Read it as gauge pressure (&quot;gauge&quot;: true).</source>
        <translation>Похоже на избыточное давление: %1 бар в нижней мёртвой точке перед сжатием. Прочтите его как избыточное (&quot;gauge&quot;: true).</translation>
    </message>
    <message>
        <source>Polytropic exponent of the compression: %1; usual: 1.25 to 1.42. Check the phase of the crank angles and the zero of the pressure.</source>
        <translation>Показатель политропы сжатия: %1; обычно 1,25–1,42. Проверьте фазу углов и нуль давления.</translation>
    </message>
    <message>
        <source>Crankshaft speed.</source>
        <translation>Частота вращения коленчатого вала.</translation>
    </message>
    <message>
        <source>Half the stroke.</source>
        <translation>Половина хода поршня.</translation>
    </message>
    <message>
        <source>Stro&amp;ke 2 r</source>
        <translation>&amp;Ход 2 r</translation>
    </message>
    <message>
        <source>Twice the crank radius.</source>
        <translation>Удвоенный радиус кривошипа.</translation>
    </message>
    <message>
        <source>Diameter of the cylinder; a pressure trace or a computed cycle needs it.</source>
        <translation>Диаметр цилиндра; нужен для индикаторной диаграммы и расчёта цикла.</translation>
    </message>
    <message>
        <source>Mass of the piston.</source>
        <translation>Масса поршня.</translation>
    </message>
    <message>
        <source>Mass of the piston pin.</source>
        <translation>Масса поршневого пальца.</translation>
    </message>
    <message>
        <source>Mass of the piston rings.</source>
        <translation>Масса поршневых колец.</translation>
    </message>
    <message>
        <source>Part of the rod&apos;s mass that moves with the piston.</source>
        <translation>Часть массы шатуна, отнесённая к оси поршневого пальца.</translation>
    </message>
    <message>
        <source>From the axis to the centre of mass of each of the two equal counterweights.</source>
        <translation>От оси до центра масс каждого из двух одинаковых противовесов.</translation>
    </message>
    <message>
        <source>From the crank axis to the shaft axis.</source>
        <translation>От оси коленчатого вала до оси балансирного.</translation>
    </message>
    <message>
        <source>The relief of %1 is longer than two bores: check the length of the crankcase.</source>
        <translation>Лыска длиной %1 больше двух диаметров цилиндра: проверьте длину картера.</translation>
    </message>
    <message>
        <source>Mass of the whole rod, including the small-end share above; the crank&apos;s own counterweights balance the rest.</source>
        <translation>Масса всего шатуна с долей у пальца, указанной выше; остальное уравновешивают противовесы самого коленчатого вала.</translation>
    </message>
    <message>
        <source>Mass of one of the two equal counterweights.</source>
        <translation>Масса одного из двух одинаковых противовесов.</translation>
    </message>
    <message>
        <source>Criteria use the curve between the rows.</source>
        <translation>Критерии относятся к кривой между строками.</translation>
    </message>
    <message>
        <source>First order, mⱼ r ω².</source>
        <translation>Первый порядок, mⱼ r ω².</translation>
    </message>
    <message>
        <source>Mass of each of the two counterweights, mⱼ r / (2 ρ₁), eq. (1), or as entered.</source>
        <translation>Масса каждого из двух противовесов, mⱼ r / (2 ρ₁), формула (1), или заданная.</translation>
    </message>
    <message>
        <source>Load on the shaft bearings, P₁</source>
        <translation>Нагрузка подшипников вала, P₁</translation>
    </message>
    <message>
        <source>Force on both bearings of the shaft together; it rotates with the shaft.</source>
        <translation>Сила на оба подшипника вала вместе; вращается с валом.</translation>
    </message>
    <message>
        <source>Amplitude of Mₛ, P₁ l</source>
        <translation>Амплитуда Mₛ, P₁ l</translation>
    </message>
    <message>
        <source>Maximum moment of the shaft.</source>
        <translation>Максимальный момент вала.</translation>
    </message>
    <message>
        <source>excess work ΔE</source>
        <translation>избыточная работа ΔE</translation>
    </message>
    <message>
        <source>Maximum minus minimum of ∫ (Mᵢ − mean) dφ over the cycle.</source>
        <translation>Максимум минус минимум ∫ (Mᵢ − среднее) dφ за цикл.</translation>
    </message>
    <message>
        <source>speed fluctuation δ</source>
        <translation>неравномерность вращения δ</translation>
    </message>
    <message>
        <source>(ω_max − ω_min) / ω = ΔE / (J ω²).</source>
        <translation>(ω_max − ω_min) / ω = ΔE / (J ω²).</translation>
    </message>
    <message>
        <source>moment of inertia J</source>
        <translation>момент инерции J</translation>
    </message>
    <message>
        <source>Moment of inertia of all rotating parts, ΔE / (δ ω²).</source>
        <translation>Момент инерции всех вращающихся частей, ΔE / (δ ω²).</translation>
    </message>
    <message>
        <source>Piston area times stroke.</source>
        <translation>Площадь поршня, умноженная на ход.</translation>
    </message>
    <message>
        <source>Displacement / (compression ratio − 1).</source>
        <translation>Рабочий объём / (степень сжатия − 1).</translation>
    </message>
    <message>
        <source>heat per cycle</source>
        <translation>теплота за цикл</translation>
    </message>
    <message>
        <source>Heat released by the combustion, entered or from the mean pressure.</source>
        <translation>Теплота сгорания, заданная или найденная по среднему давлению.</translation>
    </message>
    <message>
        <source>indicated work per cycle</source>
        <translation>индикаторная работа за цикл</translation>
    </message>
    <message>
        <source>∮ (p − p₀) dV.</source>
        <translation>∮ (p − p₀) dV.</translation>
    </message>
    <message>
        <source>indicated mean effective pressure</source>
        <translation>среднее индикаторное давление</translation>
    </message>
    <message>
        <source>Work of a cycle over the displacement.</source>
        <translation>Работа цикла, делённая на рабочий объём.</translation>
    </message>
    <message>
        <source>indicated power</source>
        <translation>индикаторная мощность</translation>
    </message>
    <message>
        <source>Work of a cycle times cycles a second.</source>
        <translation>Работа цикла, умноженная на число циклов в секунду.</translation>
    </message>
    <message>
        <source>Work of a cycle over its crank angle.</source>
        <translation>Работа цикла, делённая на его угол поворота.</translation>
    </message>
    <message>
        <source>Maximum pressure in the cylinder.</source>
        <translation>Максимальное давление в цилиндре.</translation>
    </message>
    <message>
        <source>first order, P</source>
        <translation>первый порядок, P</translation>
    </message>
    <message>
        <source>First-order inertia force, mⱼ r ω².</source>
        <translation>Сила инерции первого порядка, mⱼ r ω².</translation>
    </message>
    <message>
        <source>along the cylinder, (1 − κ) P</source>
        <translation>вдоль цилиндра, (1 − κ) P</translation>
    </message>
    <message>
        <source>Half-axis of the ellipse along the cylinder.</source>
        <translation>Полуось эллипса вдоль цилиндра.</translation>
    </message>
    <message>
        <source>across the cylinder, κ P</source>
        <translation>поперёк цилиндра, κ P</translation>
    </message>
    <message>
        <source>Half-axis of the ellipse across the cylinder.</source>
        <translation>Полуось эллипса поперёк цилиндра.</translation>
    </message>
    <message>
        <source>first order with the shaft</source>
        <translation>первый порядок с валом</translation>
    </message>
    <message>
        <source>Residual first order with the shaft.</source>
        <translation>Остаточный первый порядок с валом.</translation>
    </message>
    <message>
        <source>second order, λ mⱼ r ω²</source>
        <translation>второй порядок, λ mⱼ r ω²</translation>
    </message>
    <message>
        <source>Second order along the cylinder, with and without a shaft.</source>
        <translation>Второй порядок вдоль цилиндра, с валом и без него.</translation>
    </message>
    <message>
        <source>Constant force that turns against the crank, 2 P₁ |sin(δ/2)|.</source>
        <translation>Постоянная сила, вращающаяся против кривошипа, 2 P₁ |sin(δ/2)|.</translation>
    </message>
    <message>
        <source>required unbalance</source>
        <translation>нужный дисбаланс</translation>
    </message>
    <message>
        <source>Unbalance m₁ ρ₁ of both counterweights by equation (1).</source>
        <translation>Дисбаланс m₁ ρ₁ обоих противовесов по формуле (1).</translation>
    </message>
    <message>
        <source>unbalance of the shaft</source>
        <translation>дисбаланс вала</translation>
    </message>
    <message>
        <source>U = 2/3 ρ b a³, a² = h (D − h).</source>
        <translation>U = 2/3 ρ b a³, a² = h (D − h).</translation>
    </message>
    <message>
        <source>2 a = 2 √(h (D − h)).</source>
        <translation>2 a = 2 √(h (D − h)).</translation>
    </message>
    <message>
        <source>mass milled away</source>
        <translation>снятая масса</translation>
    </message>
    <message>
        <source>ρ b times the area of the segment.</source>
        <translation>ρ b, умноженное на площадь сегмента.</translation>
    </message>
    <message>
        <source>ρ b A of the remaining section.</source>
        <translation>ρ b A оставшегося сечения.</translation>
    </message>
    <message>
        <source>centroid radius</source>
        <translation>радиус центра масс</translation>
    </message>
    <message>
        <source>U over the mass of the relieved part, on the side away from the flat.</source>
        <translation>U, делённое на массу участка с лыской; со стороны, обратной лыске.</translation>
    </message>
    <message>
        <source>minimum bar radius</source>
        <translation>мин. радиус прутка</translation>
    </message>
    <message>
        <source>Minimum bar radius for the unbalance at this length, ∛(3 U / (2 ρ b)).</source>
        <translation>Минимальный радиус прутка для дисбаланса при этой длине, ∛(3 U / (2 ρ b)).</translation>
    </message>
    <message>
        <source>minimum relief length</source>
        <translation>мин. длина лыски</translation>
    </message>
    <message>
        <source>Minimum length of the relief for the unbalance with this bar, 3 U / (2 ρ R³).</source>
        <translation>Минимальная длина лыски для дисбаланса при этом прутке, 3 U / (2 ρ R³).</translation>
    </message>
    <message>
        <source>Bending and stress of the relieved shaft, and the load on each of its bearings.</source>
        <translation>Изгиб и напряжения вала с лыской, нагрузка каждого его подшипника.</translation>
    </message>
    <message>
        <source>Fits: the range is %1 smaller than without shaft.</source>
        <translation>Помещается: размах на %1 меньше, чем без вала.</translation>
    </message>
    <message>
        <source>Fits, but the range is %1 larger than without shaft.</source>
        <translation>Помещается, но размах на %1 больше, чем без вала.</translation>
    </message>
    <message>
        <source>Fits, but does not change the range.</source>
        <translation>Помещается, но размах не меняет.</translation>
    </message>
    <message>
        <source>The RMS is %1 smaller.</source>
        <translation>СКЗ на %1 меньше.</translation>
    </message>
    <message>
        <source>The RMS is %1 larger.</source>
        <translation>СКЗ на %1 больше.</translation>
    </message>
    <message>
        <source>The RMS does not change.</source>
        <translation>СКЗ не меняется.</translation>
    </message>
    <message>
        <source>At every feasible α, range and RMS are larger than without shaft.</source>
        <translation>При всех допустимых α размах и СКЗ больше, чем без вала.</translation>
    </message>
    <message>
        <source>At every feasible α, the range is larger than without shaft.</source>
        <translation>При всех допустимых α размах больше, чем без вала.</translation>
    </message>
    <message>
        <source>At every feasible α, the RMS is larger than without shaft.</source>
        <translation>При всех допустимых α СКЗ больше, чем без вала.</translation>
    </message>
    <message>
        <source>range unchanged</source>
        <translation>размах не меняется</translation>
    </message>
    <message>
        <source>RMS unchanged</source>
        <translation>СКЗ не меняется</translation>
    </message>
    <message>
        <source>box %1 smaller</source>
        <translation>габарит меньше на %1</translation>
    </message>
    <message>
        <source>box %1 larger</source>
        <translation>габарит больше на %1</translation>
    </message>
    <message>
        <source>box unchanged</source>
        <translation>габарит без изменений</translation>
    </message>
    <message>
        <source>A steel half disc of the shaft swing radius must be %1 long for m₁ ρ₁: more than two bores.</source>
        <translation>Стальной полудиск с радиусом вращения вала должен для m₁ ρ₁ иметь длину %1: больше двух диаметров цилиндра.</translation>
    </message>
    <message>
        <source>Same unbalance as %1 at ρ₁ = %2; map and clearances use the swing radius %3.</source>
        <translation>Дисбаланс как у %1 на ρ₁ = %2; карта и зазоры используют радиус вращения %3.</translation>
    </message>
    <message>
        <source>The heading of the pressure has no unit; the numbers look like %1.</source>
        <translation>В заголовке давления нет единицы; числа похожи на %1.</translation>
    </message>
    <message>
        <source>Pressure at the bottom dead centre before compression: %1 bar. The numbers look like %2; %3 is used.</source>
        <translation>Давление в нижней мёртвой точке перед сжатием: %1 бар. Числа похожи на %2; принято %3.</translation>
    </message>
    <message>
        <source>A four-stroke cycle takes two turns, 720°; a two-stroke cycle one, 360°. Torque table and pressure trace must span the cycle.</source>
        <translation>Четырёхтактный цикл занимает два оборота, 720°; двухтактный — один, 360°. Таблица момента и индикаторная диаграмма должны охватывать цикл.</translation>
    </message>
    <message>
        <source>Volume of the cylinder</source>
        <translation>Объём цилиндра</translation>
    </message>
    <message>
        <source>V_d displacement, ε compression ratio</source>
        <translation>V_d рабочий объём, ε степень сжатия</translation>
    </message>
    <message>
        <source>Pressure of compression</source>
        <translation>Давление сжатия</translation>
    </message>
    <message>
        <source>pₐ intake pressure, Vₐ volume where the ports close, n₁ polytropic exponent</source>
        <translation>pₐ давление впуска, Vₐ объём при закрытии окон, n₁ показатель политропы</translation>
    </message>
    <message>
        <source>pₐ intake pressure, Vₐ volume at bottom dead centre, n₁ polytropic exponent</source>
        <translation>pₐ давление впуска, Vₐ объём в нижней мёртвой точке, n₁ показатель политропы</translation>
    </message>
    <message>
        <source>Heat release (Wiebe)</source>
        <translation>Тепловыделение (Вибе)</translation>
    </message>
    <message>
        <source>x burnt share, τ share of the combustion&apos;s duration, m form exponent; all is burnt at τ = 1</source>
        <translation>x выгоревшая доля, τ доля продолжительности сгорания, m показатель характера сгорания; при τ = 1 сгорело всё</translation>
    </message>
    <message>
        <source>Pressure of combustion and expansion</source>
        <translation>Давление сгорания и расширения</translation>
    </message>
    <message>
        <source>s at the start of combustion, Q heat of a cycle, n₂ polytropic exponent</source>
        <translation>s в начале сгорания, Q теплота за цикл, n₂ показатель политропы</translation>
    </message>
    <message>
        <source>Pressure with open ports</source>
        <translation>Давление при открытых окнах</translation>
    </message>
    <message>
        <source>to and from bottom dead centre φ_b; o where the ports open, pᵣ exhaust and pₐ intake pressure</source>
        <translation>до и после нижней мёртвой точки φ_b; o при открытии окон, pᵣ давление выпуска, pₐ давление впуска</translation>
    </message>
    <message>
        <source>Pressure of gas exchange</source>
        <translation>Давление газообмена</translation>
    </message>
    <message>
        <source>pᵣ from bottom to top dead centre, exhaust; pₐ from there to bottom dead centre, intake</source>
        <translation>pᵣ от нижней до верхней мёртвой точки, выпуск; pₐ далее до нижней мёртвой точки, впуск</translation>
    </message>
    <message>
        <source>must be less than %1 in magnitude, the rod length minus crank radius</source>
        <translation>по модулю должно быть меньше %1, длины шатуна минус радиус кривошипа</translation>
    </message>
    <message>
        <source>must be greater than the crank radius plus the offset, %1</source>
        <translation>должно быть больше радиуса кривошипа плюс дезаксаж, %1</translation>
    </message>
    <message>
        <source>Pressure trace: %1 between rows near the peak; peak and work are uncertain, and the dead centre requires steps of 4°.</source>
        <translation>Индикаторная диаграмма: %1 между строками у пика; пик и работа неточны, для поиска мёртвой точки нужен шаг 4°.</translation>
    </message>
    <message>
        <source>All rings of one piston.</source>
        <translation>Все кольца одного поршня.</translation>
    </message>
    <message>
        <source>One piston without pin and rings.</source>
        <translation>Один поршень без пальца и колец.</translation>
    </message>
    <message>
        <source>One piston pin.</source>
        <translation>Один поршневой палец.</translation>
    </message>
    <message>
        <source>Big end of one rod with its bolts, without shells.</source>
        <translation>Нижняя головка одного шатуна с болтами, без вкладышей.</translation>
    </message>
    <message>
        <source>must be a list of two</source>
        <translation>должен быть списком из двух</translation>
    </message>
    <message>
        <source>must be greater than the crankshaft&apos;s %1</source>
        <translation>должно быть больше, чем у вала (%1)</translation>
    </message>
    <message>
        <source>must be less than the depth, %1</source>
        <translation>должно быть меньше глубины (%1)</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V-образный</translation>
    </message>
    <message>
        <source>In line</source>
        <translation>Рядный</translation>
    </message>
    <message>
        <source>Boxer</source>
        <translation>Оппозитный</translation>
    </message>
    <message>
        <source>One</source>
        <translation>Один</translation>
    </message>
    <message>
        <source>Two</source>
        <translation>Два</translation>
    </message>
    <message>
        <source>Bank by bank</source>
        <translation>Ряд за рядом</translation>
    </message>
    <message>
        <source>1 and 2, 3 and 4, …</source>
        <translation>1 и 2, 3 и 4, …</translation>
    </message>
    <message>
        <source>Internal: in the crankshaft alone</source>
        <translation>Внутренняя: только вал</translation>
    </message>
    <message>
        <source>External: damper and flywheel too</source>
        <translation>Внешняя: ещё гаситель и маховик</translation>
    </message>
    <message>
        <source>&amp;Engine</source>
        <translation>Дви&amp;гатель</translation>
    </message>
    <message>
        <source>&amp;Cylinders</source>
        <translation>&amp;Цилиндров</translation>
    </message>
    <message>
        <source>&amp;Bank angle γ</source>
        <translation>Ра&amp;звал γ</translation>
    </message>
    <message>
        <source>&amp;Rods on a bob weight</source>
        <translation>&amp;Шатунов на грузе</translation>
    </message>
    <message>
        <source>Crankpin &amp;split δ</source>
        <translation>Разве&amp;дение шеек δ</translation>
    </message>
    <message>
        <source>Part of the reciprocating mass in the bob weight.</source>
        <translation>Часть возвратно-поступательной массы в грузе.</translation>
    </message>
    <message>
        <source>by theory</source>
        <translation>по теории</translation>
    </message>
    <message>
        <source>&amp;Overbalance</source>
        <translation>Переб&amp;аланс</translation>
    </message>
    <message>
        <source>Added to the factor; negative for underbalance. Usual for high speeds: 1 to 3 %.</source>
        <translation>Прибавляется к коэффициенту; отрицателен при недобалансе. Для высоких оборотов обычно 1–3&#xa0;%.</translation>
    </message>
    <message>
        <source>Masses of one cylinder&apos;s parts.</source>
        <translation>Массы деталей одного цилиндра.</translation>
    </message>
    <message>
        <source>C&amp;ylinders of a crankpin</source>
        <translation>&amp;Цилиндры шейки</translation>
    </message>
    <message>
        <source>Masses by cylinder.</source>
        <translation>Массы по цилиндрам.</translation>
    </message>
    <message>
        <source>B&amp;alanced</source>
        <translation>&amp;Балансировка</translation>
    </message>
    <message>
        <source>The two correction planes.</source>
        <translation>Две плоскости коррекции.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Положение</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Радиус</translation>
    </message>
    <message>
        <source>Drill from</source>
        <translation>Сверлить от</translation>
    </message>
    <message>
        <source>Drill to</source>
        <translation>Сверлить до</translation>
    </message>
    <message>
        <source>Read at</source>
        <translation>Плоскость измерения</translation>
    </message>
    <message>
        <source>the plane</source>
        <translation>плоскость</translation>
    </message>
    <message>
        <source>Unbalance</source>
        <translation>Дисбаланс</translation>
    </message>
    <message>
        <source>Reading of the machine. It has no sign: turn the angle by 180° instead.</source>
        <translation>Показание станка. Оно без знака: вместо этого поверните угол на 180°.</translation>
    </message>
    <message>
        <source>Heavy spot</source>
        <translation>Тяжёлое место</translation>
    </message>
    <message>
        <source>&amp;Drills</source>
        <translation>&amp;Свёрла</translation>
    </message>
    <message>
        <source>De&amp;nsity</source>
        <translation>&amp;Плотность</translation>
    </message>
    <message>
        <source>&amp;Point angle</source>
        <translation>&amp;Угол при вершине</translation>
    </message>
    <message>
        <source>Depth &amp;step</source>
        <translation>&amp;Шаг глубины</translation>
    </message>
    <message>
        <source>&amp;Wall between holes</source>
        <translation>С&amp;тенка между отверстиями</translation>
    </message>
    <message>
        <source>Heavy metal pressed in opposite the heavy spot.</source>
        <translation>Тяжёлый металл, запрессованный напротив тяжёлого места.</translation>
    </message>
    <message>
        <source>Slug diame&amp;ter</source>
        <translation>&amp;Диаметр вставки</translation>
    </message>
    <message>
        <source>no slugs</source>
        <translation>без вставок</translation>
    </message>
    <message>
        <source>Slug dens&amp;ity</source>
        <translation>П&amp;лотность вставки</translation>
    </message>
    <message>
        <source>Tungsten heavy metal 17 000 to 18 500 kg/m³.</source>
        <translation>Тяжёлый сплав вольфрама 17 000–18 500 кг/м³.</translation>
    </message>
    <message>
        <source>&amp;Limit of a plane</source>
        <translation>&amp;Допуск плоскости</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>Центр масс</translation>
    </message>
    <message>
        <source>midway</source>
        <translation>посередине</translation>
    </message>
    <message>
        <source>Front bearing</source>
        <translation>Передний подшипник</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>не задан</translation>
    </message>
    <message>
        <source>Rear bearing</source>
        <translation>Задний подшипник</translation>
    </message>
    <message>
        <source>Masses of one cylinder</source>
        <translation>Массы одного цилиндра</translation>
    </message>
    <message>
        <source>First-order force of a piston</source>
        <translation>Сила поршня первого порядка</translation>
    </message>
    <message>
        <source>β direction of the cylinder, ψ of its crankpin: one half turns with the crank, one against it</source>
        <translation>β — направление цилиндра, ψ — его шейки: одна половина вращается с валом, другая против него</translation>
    </message>
    <message>
        <source>Bob weight</source>
        <translation>Балансировочный груз</translation>
    </message>
    <message>
        <source>A, B vectors read at a, b; U₁, U₂ in the planes at z₁, z₂: same force, same moment</source>
        <translation>A, B — векторы, измеренные в a, b; U₁, U₂ — в плоскостях z₁, z₂: та же сила, тот же момент</translation>
    </message>
    <message>
        <source>Unbalance that a hole takes off</source>
        <translation>Дисбаланс, снимаемый отверстием</translation>
    </message>
    <message>
        <source>The crankshaft is rigid.</source>
        <translation>Коленчатый вал жёсткий.</translation>
    </message>
    <message>
        <source>V-6, 90°, even firing (crankpins split by 30°)</source>
        <translation>V-6, 90°, вспышки равномерны (шейки разведены на 30°)</translation>
    </message>
    <message>
        <source>V-6, 60°, even firing (crankpins split by 60°)</source>
        <translation>V-6, 60°, вспышки равномерны (шейки разведены на 60°)</translation>
    </message>
    <message>
        <source>V-6, 90°, odd firing</source>
        <translation>V-6, 90°, вспышки неравномерны</translation>
    </message>
    <message>
        <source>V-10, 72°</source>
        <translation>V-10, 72°</translation>
    </message>
    <message>
        <source>V-12, 60°</source>
        <translation>V-12, 60°</translation>
    </message>
    <message>
        <source>V-twin, 45°</source>
        <translation>V-2, 45°</translation>
    </message>
    <message>
        <source>Flat twin, a crankpin for each rod</source>
        <translation>Оппозитный двухцилиндровый, шейка на каждый шатун</translation>
    </message>
    <message>
        <source>One cylinder</source>
        <translation>Один цилиндр</translation>
    </message>
    <message>
        <source>must leave a factor of 0 or more</source>
        <translation>должно оставлять коэффициент не меньше 0</translation>
    </message>
    <message>
        <source>S&amp;hells of one rod</source>
        <translation>Вклад&amp;ыши одного шатуна</translation>
    </message>
    <message>
        <source>&amp;Oil of one crankpin</source>
        <translation>&amp;Масло одной шейки</translation>
    </message>
    <message>
        <source>must be a list of at most %1</source>
        <translation>должен быть список не длиннее %1</translation>
    </message>
    <message>
        <source>Along the crankshaft.</source>
        <translation>Вдоль вала.</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Передняя</translation>
    </message>
    <message>
        <source>Rear</source>
        <translation>Задняя</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Плоскость</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Отверстие</translation>
    </message>
    <message>
        <source>Diameter of hole or slug.</source>
        <translation>Диаметр отверстия или вставки.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Глубина</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Угол</translation>
    </message>
    <message>
        <source>Takes off</source>
        <translation>Снимает</translation>
    </message>
    <message>
        <source>mⱼ reciprocating, mᵣ rotating mass; m₁ rings, m₂ piston, m₃ pin, m₄ locks, m₅ small end, m₆ big end, m₇ shells</source>
        <translation>mⱼ — возвратно-поступательная, mᵣ — вращающаяся масса; m₁ — кольца, m₂ — поршень, m₃ — палец, m₄ — стопорные кольца, m₅ — верхняя головка, m₆ — нижняя головка, m₇ — вкладыши</translation>
    </message>
    <message>
        <source>n rods on it, mₘ oil in the crankpin</source>
        <translation>n — шатунов на нём, mₘ — масло в шейке</translation>
    </message>
    <message>
        <source>Slug</source>
        <translation>Вставка</translation>
    </message>
    <message>
        <source>R radius of the rim, d diameter, h depth of the full diameter, σ angle of the point, ρ density</source>
        <translation>R — радиус обода, d — диаметр, h — глубина по полному диаметру, σ — угол при вершине, ρ — плотность</translation>
    </message>
    <message>
        <source>Unbalance that a slug adds</source>
        <translation>Дисбаланс, который прибавляет вставка</translation>
    </message>
    <message>
        <source>Rotating mass</source>
        <translation>Вращающаяся масса</translation>
    </message>
    <message>
        <source>Balance factor</source>
        <translation>Коэффициент балансировки</translation>
    </message>
    <message>
        <source>Number of bob weights</source>
        <translation>Число балансировочных грузов</translation>
    </message>
    <message>
        <source>Theory</source>
        <translation>Теория</translation>
    </message>
    <message>
        <source>Cylinders</source>
        <translation>Цилиндры</translation>
    </message>
    <message>
        <source>Force with the crank</source>
        <translation>Сила, вращающаяся с кривошипом</translation>
    </message>
    <message>
        <source>Force against the crank</source>
        <translation>Сила, вращающаяся против кривошипа</translation>
    </message>
    <message>
        <source>Vertical force</source>
        <translation>Вертикальная сила</translation>
    </message>
    <message>
        <source>Horizontal force</source>
        <translation>Горизонтальная сила</translation>
    </message>
    <message>
        <source>Bob weights of the crankpins</source>
        <translation>Балансировочные грузы шатунных шеек</translation>
    </message>
    <message>
        <source>Permissible</source>
        <translation>Допустимый дисбаланс</translation>
    </message>
    <message>
        <source>Permissible, whole shaft</source>
        <translation>Допустимый дисбаланс, весь вал</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Коррекция</translation>
    </message>
    <message>
        <source>Mass at drilling radius</source>
        <translation>Масса на радиусе сверления</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Остаточный дисбаланс</translation>
    </message>
    <message>
        <source>Direction of the residual</source>
        <translation>Направление остаточного дисбаланса</translation>
    </message>
    <message>
        <source>Within tolerance as measured</source>
        <translation>В допуске по показаниям</translation>
    </message>
    <message>
        <source>Within tolerance</source>
        <translation>В допуске</translation>
    </message>
    <message>
        <source>Edge beyond the sector</source>
        <translation>Край за пределами сектора</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Пуск</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Ожидалось</translation>
    </message>
    <message>
        <source>Drilling acted the opposite way</source>
        <translation>Сверление подействовало наоборот</translation>
    </message>
    <message>
        <source>Drilled hole</source>
        <translation>Просверленное отверстие</translation>
    </message>
    <message>
        <source>Pressed-in slug</source>
        <translation>Запрессованная вставка</translation>
    </message>
    <message>
        <source>Amplification of errors</source>
        <translation>Усиление погрешностей</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Диаметр</translation>
    </message>
    <message>
        <source>Takes off, unbalance</source>
        <translation>Снимает, дисбаланс</translation>
    </message>
    <message>
        <source>Adds</source>
        <translation>Добавляет</translation>
    </message>
    <message>
        <source>Adds, unbalance</source>
        <translation>Добавляет, дисбаланс</translation>
    </message>
    <message>
        <source>Mass of the slug</source>
        <translation>Масса вставки</translation>
    </message>
    <message>
        <source>Hang a bob weight of %1 on the crankpin.</source>
        <translation>Навесьте на шатунную шейку балансировочный груз %1.</translation>
    </message>
    <message>
        <source>Hang bob weights of %1 on the %2 crankpins.</source>
        <translation>Навесьте балансировочные грузы по %1 на шатунные шейки: %2.</translation>
    </message>
    <message>
        <source>A mass of %1 looks like kilograms.</source>
        <translation>Масса %1 похожа на введённую в килограммах.</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Ноль</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Предел</translation>
    </message>
    <message>
        <source>Parallel to the crankshaft</source>
        <translation>Параллельно валу</translation>
    </message>
    <message>
        <source>Radial, open at the rim</source>
        <translation>Радиально, открыто на ободе</translation>
    </message>
    <message>
        <source>As planned</source>
        <translation>По плану</translation>
    </message>
    <message>
        <source>As measured</source>
        <translation>По измерению</translation>
    </message>
    <message>
        <source>Not drilled</source>
        <translation>Не просверлено</translation>
    </message>
    <message>
        <source>On the wrong side</source>
        <translation>Не с той стороны</translation>
    </message>
    <message>
        <source>Minimum depth</source>
        <translation>Минимальная глубина</translation>
    </message>
    <message>
        <source>Minimum depth of a new hole.</source>
        <translation>Минимальная глубина нового отверстия.</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>Цель</translation>
    </message>
    <message>
        <source>Depth before</source>
        <translation>Глубина до углубления</translation>
    </message>
    <message>
        <source>Depth of the hole before it was deepened.</source>
        <translation>Глубина отверстия до углубления.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Направление</translation>
    </message>
    <message>
        <source>Direction of a slug.</source>
        <translation>Направление вставки.</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Состояние</translation>
    </message>
    <message>
        <source>Centrifugal force</source>
        <translation>Центробежная сила</translation>
    </message>
    <message>
        <source>Enter the reading of the other plane.</source>
        <translation>Введите показание другой плоскости.</translation>
    </message>
    <message>
        <source>There is too little room for the holes.</source>
        <translation>Отверстиям мало места.</translation>
    </message>
    <message>
        <source>After the planned correction: %1 %3, %2 %4.</source>
        <translation>После плановой коррекции: %3 %1, %4 %2.</translation>
    </message>
    <message>
        <source>Banks at %1, crankpins split by %2: the backward parts of the first order cancel, 50 % balances the rest. First-order force fully balanced.</source>
        <translation>Развал %1, шейки разведены на %2: обратные части первого порядка взаимно уничтожаются, 50&#xa0;% уравновешивают остальное. Сила первого порядка уравновешена полностью.</translation>
    </message>
    <message>
        <source>Banks at %1, crankpins split by %2: %3 of the reciprocating mass turns against the crank, with the crank only %4 even at 0 %. With a backward balance shaft use 50 %.</source>
        <translation>Развал %1, шейки разведены на %2: против вала вращается %3 возвратно-поступательной массы, с валом только %4 даже при 0&#xa0;%. С балансирным валом встречного вращения — 50&#xa0;%.</translation>
    </message>
    <message>
        <source>Banks at %1, crankpins split by %2: %3 of the reciprocating mass turns against the crank. At %4 the residual is a straight motion, easiest on the mounts; with a backward balance shaft use 50 %.</source>
        <translation>Развал %1, шейки разведены на %2: %3 возвратно-поступательной массы вращается против вала. При %4 остаток — прямолинейное движение, самое лёгкое для опор; с балансирным валом встречного вращения — 50&#xa0;%.</translation>
    </message>
    <message>
        <source>Two cylinders at 90° on one crankpin: their first-order forces add up to a constant force that turns with the crank. 50 % balances it fully.</source>
        <translation>Два цилиндра под 90° на одной шейке: их силы первого порядка складываются в постоянную силу, вращающуюся с валом. 50&#xa0;% уравновешивают её полностью.</translation>
    </message>
    <message>
        <source>Banks at %1: 50 % balances the forward part of the first order. Counterweights cannot balance the backward part, %2 of the reciprocating mass.</source>
        <translation>Развал %1: 50&#xa0;% уравновешивают прямую часть первого порядка. Обратную часть, %2 возвратно-поступательной массы, противовесы уравновесить не могут.</translation>
    </message>
    <message>
        <source>Banks at %1: 50 % balances the forward part of the first order. The backward part, %2 of the reciprocating mass, may cancel between the crankpins, not by counterweights.</source>
        <translation>Развал %1: 50&#xa0;% уравновешивают прямую часть первого порядка. Обратную часть, %2 возвратно-поступательной массы, могут погасить шейки вместе, но не противовесы.</translation>
    </message>
    <message>
        <source>Boxer: opposite pistons cancel each other&apos;s force. The factor affects residual couple and main bearing load; 50 % minimises the maximum.</source>
        <translation>Оппозитный: противолежащие поршни уничтожают силу друг друга. Коэффициент влияет на остаточный момент и нагрузку коренных подшипников; 50&#xa0;% минимизируют максимум.</translation>
    </message>
    <message>
        <source>In line: 50 % halves the first-order force of each piston. If the crankpins balance one another (four, six in line), equal bob weights are not needed.</source>
        <translation>Рядный: 50&#xa0;% вдвое уменьшают силу первого порядка каждого поршня. Если шейки уравновешивают друг друга (четыре, шесть в ряд), одинаковые грузы не нужны.</translation>
    </message>
    <message>
        <source>Each rod on its own crankpin: 50 % leaves half the first-order force of each piston, turning against the crank.</source>
        <translation>У каждого шатуна своя шейка: 50&#xa0;% оставляют половину силы первого порядка каждого поршня, вращающуюся против вала.</translation>
    </message>
    <message>
        <source>First-order force fully balanced.</source>
        <translation>Сила первого порядка уравновешена полностью.</translation>
    </message>
    <message>
        <source>Residual: a circle against the crank, %1 of the reciprocating mass of a cylinder.</source>
        <translation>Остаток: круг против вала, %1 возвратно-поступательной массы цилиндра.</translation>
    </message>
    <message>
        <source>Residual: a circle with the crank, %1 of the reciprocating mass of a cylinder.</source>
        <translation>Остаток: круг с валом, %1 возвратно-поступательной массы цилиндра.</translation>
    </message>
    <message>
        <source>Residual: a straight vertical motion, %1 of the reciprocating mass of a cylinder.</source>
        <translation>Остаток: прямолинейное движение по вертикали, %1 возвратно-поступательной массы цилиндра.</translation>
    </message>
    <message>
        <source>Residual: a straight horizontal motion, %1 of the reciprocating mass of a cylinder.</source>
        <translation>Остаток: прямолинейное движение по горизонтали, %1 возвратно-поступательной массы цилиндра.</translation>
    </message>
    <message>
        <source>Residual: an ellipse, %1 of the reciprocating mass of a cylinder vertically, %2 horizontally.</source>
        <translation>Остаток: эллипс, %1 возвратно-поступательной массы цилиндра по вертикали, %2 по горизонтали.</translation>
    </message>
    <message>
        <source>The locks of one pin; 0 for a pressed pin.</source>
        <translation>Стопорные кольца одного пальца; 0, если палец запрессован.</translation>
    </message>
    <message>
        <source>Small end of one rod, with the big end supported at the same level.</source>
        <translation>Верхняя головка одного шатуна, нижняя подвешена на том же уровне.</translation>
    </message>
    <message>
        <source>Both shells of one rod, not of the whole crankpin; each rod adds its own.</source>
        <translation>Оба вкладыша одного шатуна, а не всей шейки; каждый шатун добавляет свои.</translation>
    </message>
    <message>
        <source>Oil in and around one crankpin, once for all its rods; usually 4 g.</source>
        <translation>Масло в одной шейке и около неё, один раз на все её шатуны; обычно 4 г.</translation>
    </message>
    <message>
        <source>The engine.</source>
        <translation>Двигатель.</translation>
    </message>
    <message>
        <source>Layout of the cylinders.</source>
        <translation>Расположение цилиндров.</translation>
    </message>
    <message>
        <source>Number of cylinders.</source>
        <translation>Число цилиндров.</translation>
    </message>
    <message>
        <source>Angle between the two banks of a V.</source>
        <translation>Угол между рядами V-образного двигателя.</translation>
    </message>
    <message>
        <source>Two if two rods share a crankpin. Each split crankpin has one rod and one bob weight.</source>
        <translation>Два, если на шейке два шатуна. На каждой из разведённых шеек один шатун и один груз.</translation>
    </message>
    <message>
        <source>Angle between the two crankpins of a throw; positive if the firing interval is γ + δ. A 90° V-6 with 30° fires evenly.</source>
        <translation>Угол между двумя шейками колена; положителен, если интервал между вспышками γ + δ. При 30° вспышки V-6 90° равномерны.</translation>
    </message>
    <message>
        <source>Balance &amp;factor</source>
        <translation>&amp;Коэффициент балансировки</translation>
    </message>
    <message>
        <source>by theory; prefer the manufacturer&apos;s figure</source>
        <translation>по теории; надёжнее данные изготовителя</translation>
    </message>
    <message>
        <source>Balance an externally balanced crankshaft with damper and flywheel in place.</source>
        <translation>Вал с внешней балансировкой балансируйте с гасителем колебаний и маховиком.</translation>
    </message>
    <message>
        <source>Readings of the machine and their correction.</source>
        <translation>Показания станка и их коррекция.</translation>
    </message>
    <message>
        <source>Position along the crankshaft, from any point; use the same point for planes, readings and bearings.</source>
        <translation>Положение вдоль вала, от любой точки; одной для плоскостей, показаний и подшипников.</translation>
    </message>
    <message>
        <source>From the axis to the drilled rim; masses to take off refer to this radius.</source>
        <translation>От оси до обода, который сверлят; снимаемые массы относятся к этому радиусу.</translation>
    </message>
    <message>
        <source>whole rim</source>
        <translation>весь обод</translation>
    </message>
    <message>
        <source>End of the sector, towards larger angles.</source>
        <translation>Конец сектора, в сторону больших углов.</translation>
    </message>
    <message>
        <source>Readings of the latest run, with the bob weights on the crankpins.</source>
        <translation>Показания последнего пуска, с грузами на шейках.</translation>
    </message>
    <message>
        <source>Runs before the latest; the first is the crankshaft as received. Each has two readings, at the positions of the latest.</source>
        <translation>Пуски до последнего; первый — вал при поступлении. У каждого два показания, в тех же местах, что и последние.</translation>
    </message>
    <message>
        <source>Readings of that run.</source>
        <translation>Показания этого пуска.</translation>
    </message>
    <message>
        <source>Position of the reading.</source>
        <translation>Положение измерения.</translation>
    </message>
    <message>
        <source>in the correction plane</source>
        <translation>в самой плоскости коррекции</translation>
    </message>
    <message>
        <source>Angle shown</source>
        <translation>Показанный угол</translation>
    </message>
    <message>
        <source>Angle that the machine shows, from its zero mark: of the heavy spot, or of the light spot, 180° away. A reading of 0 has no angle.</source>
        <translation>Угол, который показывает станок, от его нулевой метки: тяжёлого места или лёгкого, 180° от него. У показания 0 угла нет.</translation>
    </message>
    <message>
        <source>Available drills.</source>
        <translation>Имеющиеся свёрла.</translation>
    </message>
    <message>
        <source>Diameters of the available drills.</source>
        <translation>Диаметры имеющихся свёрл.</translation>
    </message>
    <message>
        <source>Density of the crankshaft: steel 7850, cast iron 7200 kg/m³.</source>
        <translation>Плотность вала: сталь 7850, чугун 7200 кг/м³.</translation>
    </message>
    <message>
        <source>&amp;Maximum depth</source>
        <translation>&amp;Максимальная глубина</translation>
    </message>
    <message>
        <source>Depth of the full diameter, without the drill point; of an axial slug at most the thickness of the counterweight.</source>
        <translation>Глубина по полному диаметру, без конуса сверла; для осевой вставки – не больше толщины противовеса.</translation>
    </message>
    <message>
        <source>Depth of the full diameter, without the drill point.</source>
        <translation>Глубина по полному диаметру, без конуса сверла.</translation>
    </message>
    <message>
        <source>Angle of the drill&apos;s point: 118°, 135°; 180° for a flat end. It applies to holes of slugs too.</source>
        <translation>Угол при вершине сверла: 118°, 135°; 180° — плоский торец. Относится и к отверстиям вставок.</translation>
    </message>
    <message>
        <source>Depths are rounded to this step. 0: no rounding.</source>
        <translation>Глубины округляются до этого шага. 0: без округления.</translation>
    </message>
    <message>
        <source>Minimum wall between two holes at their bottoms, and between an axial slug and the rim.</source>
        <translation>Минимальная стенка между отверстиями у дна, а также между осевой вставкой и ободом.</translation>
    </message>
    <message>
        <source>Maximum h&amp;oles</source>
        <translation>&amp;Отверстий не больше</translation>
    </message>
    <message>
        <source>Maximum number of holes in one plane.</source>
        <translation>Максимум отверстий в одной плоскости.</translation>
    </message>
    <message>
        <source>Max. an&amp;gle from heavy spot</source>
        <translation>Предельный &amp;угол от тяжёлого места</translation>
    </message>
    <message>
        <source>Maximum angle from the heavy spot to a hole, on either side.</source>
        <translation>Предельный угол от тяжёлого места до отверстия, с каждой стороны.</translation>
    </message>
    <message>
        <source>Take off as much as possible, or stop within the limit with the fewest holes.</source>
        <translation>Снять как можно больше или остановиться в пределах допуска с минимумом отверстий.</translation>
    </message>
    <message>
        <source>Holes and slugs planned after that run; later holes keep clear of them. Without a list they are planned from its readings.</source>
        <translation>Отверстия и вставки, рассчитанные после этого пуска; следующие их обходят. Без списка они рассчитываются по его показаниям.</translation>
    </message>
    <message>
        <source>Holes of the latest run, if a further run was begun and cleared again.</source>
        <translation>Отверстия последнего пуска, если следующий был начат и стёрт.</translation>
    </message>
    <message>
        <source>Readings from which the holes were planned, if they were corrected since.</source>
        <translation>Показания, по которым рассчитаны отверстия, если их потом исправили.</translation>
    </message>
    <message>
        <source>Plane of the hole.</source>
        <translation>Плоскость отверстия.</translation>
    </message>
    <message>
        <source>Angle from the machine&apos;s zero mark.</source>
        <translation>Угол от нулевой метки станка.</translation>
    </message>
    <message>
        <source>Mass taken off; negative for a slug, minus the mass of its hole.</source>
        <translation>Снятая масса; отрицательна для вставки, за вычетом массы её отверстия.</translation>
    </message>
    <message>
        <source>Unbalance that the plan takes off.</source>
        <translation>Дисбаланс, который снимает план.</translation>
    </message>
    <message>
        <source>Mass of the slug itself.</source>
        <translation>Собственная масса вставки.</translation>
    </message>
    <message>
        <source>Actual drilling. Measured: depth and angle as found; wrong side: half a turn from the given angle.</source>
        <translation>Как просверлено на самом деле. По измерению: глубина и угол измерены; не с той стороны: в пол-обороте от указанного угла.</translation>
    </message>
    <message>
        <source>Diameter of the available slugs.</source>
        <translation>Диаметр имеющихся вставок.</translation>
    </message>
    <message>
        <source>Direction in which slugs are pressed in.</source>
        <translation>Направление запрессовки вставок.</translation>
    </message>
    <message>
        <source>Permissible residual unbalance in each plane.</source>
        <translation>Допустимый остаточный дисбаланс в каждой плоскости.</translation>
    </message>
    <message>
        <source>With both end bearings the standard&apos;s limits apply there; the limits of the planes follow from the distances.</source>
        <translation>Если заданы оба крайних подшипника, допуски стандарта действуют в них, а допуски плоскостей следуют из расстояний.</translation>
    </message>
    <message>
        <source>the standard&apos;s limits are shared between the planes</source>
        <translation>допуск по стандарту делится между плоскостями</translation>
    </message>
    <message>
        <source>Share of the permissible unbalance, without positions of bearings or centre of mass.</source>
        <translation>Доля допустимого дисбаланса, если не заданы подшипники и центр масс.</translation>
    </message>
    <message>
        <source>Residual after the counterweights</source>
        <translation>Остаток после противовесов</translation>
    </message>
    <message>
        <source>of the cylinders of a throw; F factor with overbalance, γ bank angle, δ split of the crankpins, φ direction of the throw from the middle of the banks</source>
        <translation>цилиндров одного колена; F — коэффициент с перебалансом, γ — развал, δ — разведение шеек, φ — направление колена от середины развала</translation>
    </message>
    <message>
        <source>Balance factor by theory</source>
        <translation>Коэффициент балансировки по теории</translation>
    </message>
    <message>
        <source>Readings transferred to the planes</source>
        <translation>Показания, перенесённые в плоскости</translation>
    </message>
    <message>
        <source>ρₛ density of the slug, h its length, u unbalance of its hole; the cone below is empty</source>
        <translation>ρₛ — плотность вставки, h — её длина, u — дисбаланс её отверстия; конус под ней пуст</translation>
    </message>
    <message>
        <source>The factor uses the first order only; bob weights cannot affect higher orders.</source>
        <translation>Коэффициент учитывает только первый порядок; на высшие порядки грузы не влияют.</translation>
    </message>
    <message>
        <source>Couples along the crankshaft are not part of the factor: see inertia moments.</source>
        <translation>Моменты вдоль вала в коэффициент не входят: см. моменты сил инерции.</translation>
    </message>
    <message>
        <source>The rim of a counterweight is taken as flat at a hole.</source>
        <translation>Обод противовеса в месте отверстия считается плоским.</translation>
    </message>
    <message>
        <source>All bob weights are equal, from the means of the weighed parts.</source>
        <translation>Все грузы одинаковы, со средними взвешенных деталей.</translation>
    </message>
    <message>
        <source>must be even if two rods share a bob weight</source>
        <translation>должно быть чётным, если на грузе два шатуна</translation>
    </message>
    <message>
        <source>must be 1 for cylinders in line</source>
        <translation>должно быть 1 для рядного двигателя</translation>
    </message>
    <message>
        <source>must be 0 except for a V</source>
        <translation>должно быть 0, если двигатель не V-образный</translation>
    </message>
    <message>
        <source>must differ from the first</source>
        <translation>значение должно отличаться от первого</translation>
    </message>
    <message>
        <source>must be left out if centre of mass or bearings are given</source>
        <translation>не указывается, если её задают центр масс или подшипники</translation>
    </message>
    <message>
        <source>%1: the weighed masses replace the typed %2.</source>
        <translation>%1: взвешенные массы заменяют введённое %2.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 weighed; the typed mass is used until all are weighed.</source>
        <translation>%1: взвешено %2 из %3; пока не все, используется введённая масса.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 weighed; not used until all are weighed.</source>
        <translation>%1: взвешено %2 из %3; пока не все, не используются.</translation>
    </message>
    <message>
        <source>Mass of one cylinder.</source>
        <translation>Масса одного цилиндра.</translation>
    </message>
    <message>
        <source>Centrifugal force of the slug at the service speed.</source>
        <translation>Центробежная сила вставки при рабочей частоте.</translation>
    </message>
    <message>
        <source>No bob weights are needed: the crankpins balance one another. If you use them: %1 each.</source>
        <translation>Балансировочные грузы не нужны: шатунные шейки уравновешивают друг друга. Если используете: по %1.</translation>
    </message>
    <message>
        <source>Enter the permissible residual for a verdict.</source>
        <translation>Для вывода введите допустимый остаточный дисбаланс.</translation>
    </message>
    <message>
        <source>The last drilling did not have the planned effect: find the cause before drilling again.</source>
        <translation>Последнее сверление подействовало не так, как планировалось: прежде чем сверлить дальше, выясните причину.</translation>
    </message>
    <message>
        <source>The smallest hole takes off too much: use a smaller drill or a flatter point.</source>
        <translation>Самое малое отверстие снимает слишком много: возьмите сверло тоньше или с более плоским концом.</translation>
    </message>
    <message>
        <source>Rounding of the depths leaves more than the limit: use a finer step or a smaller drill.</source>
        <translation>Округление глубин оставляет больше допуска: возьмите шаг мельче или сверло тоньше.</translation>
    </message>
    <message>
        <source>The heavy spot is outside the drilling sector; holes at its edge take off only a part.</source>
        <translation>Тяжёлое место вне сектора сверления, а отверстия на его краю снимают только часть.</translation>
    </message>
    <message>
        <source>The heavy spot is outside the drilling sector.</source>
        <translation>Тяжёлое место вне сектора сверления.</translation>
    </message>
    <message>
        <source>Slugs of %1 are hardly heavier than the crankshaft metal (%2) of their holes: none are planned.</source>
        <translation>Вставки плотностью %1 едва тяжелее металла вала (%2), который снимают их отверстия: они не планируются.</translation>
    </message>
    <message>
        <source>A slug of %1 of maximum depth is lighter than the crankshaft metal (%2) of its hole with the cone: none are planned.</source>
        <translation>Вставка плотностью %1 на предельную глубину легче металла вала (%2) из её отверстия с конусом: вставок нет.</translation>
    </message>
    <message>
        <source>There is too little room next to the holes of earlier runs.</source>
        <translation>Рядом с отверстиями прежних пусков отверстиям мало места.</translation>
    </message>
    <message>
        <source>Residual: %1 at the drilling radius at %2.</source>
        <translation>Остаток: %1 на радиусе сверления под углом %2.</translation>
    </message>
    <message>
        <source>The opposite side is outside the sector too: drill deeper or wider.</source>
        <translation>Противоположная сторона тоже вне сектора: сверлите глубже или шире.</translation>
    </message>
    <message>
        <source>As a last resort weld an equal mass at %1.</source>
        <translation>В крайнем случае приварите равную массу на угле %1.</translation>
    </message>
    <message>
        <source>Press in heavy metal opposite, or drill deeper or wider.</source>
        <translation>Запрессуйте тяжёлый металл напротив, сверлите глубже или шире.</translation>
    </message>
    <message>
        <source>No bob weights are needed: the crankpins balance one another.</source>
        <translation>Балансировочные грузы не нужны: шатунные шейки уравновешивают друг друга.</translation>
    </message>
    <message>
        <source>Four in line</source>
        <translation>Рядный четырёхцилиндровый</translation>
    </message>
    <message>
        <source>Start of the drilling sector of the counterweight. New holes are wholly inside.</source>
        <translation>Начало сектора сверления на противовесе. Новые отверстия лежат в нём целиком.</translation>
    </message>
    <message>
        <source>The opposite side is outside the sector too: widen the sector if there is metal.</source>
        <translation>Противоположная сторона тоже вне сектора: расширьте сектор, если там есть металл.</translation>
    </message>
    <message>
        <source>Press in heavy metal opposite.</source>
        <translation>Запрессуйте тяжёлый металл напротив.</translation>
    </message>
    <message>
        <source>Radius of the hole centre</source>
        <translation>Радиус центра отверстия</translation>
    </message>
    <message>
        <source>Radius of the slug&apos;s centre about the crank axis.</source>
        <translation>Расстояние центра вставки от оси вала.</translation>
    </message>
    <message>
        <source>True if the machine counted degrees in the other direction during drilling.</source>
        <translation>True, если при сверлении станок отсчитывал градусы в другую сторону.</translation>
    </message>
    <message>
        <source>Drilling acted in the other plane</source>
        <translation>Сверление подействовало в другой плоскости</translation>
    </message>
    <message>
        <source>One &amp;piston</source>
        <translation>Один порше&amp;нь</translation>
    </message>
    <message>
        <source>One p&amp;in</source>
        <translation>Один п&amp;алец</translation>
    </message>
    <message>
        <source>Rin&amp;gs of one piston</source>
        <translation>&amp;Кольца одного поршня</translation>
    </message>
    <message>
        <source>Loc&amp;ks of one pin</source>
        <translation>&amp;Стопорные кольца пальца</translation>
    </message>
    <message>
        <source>S&amp;mall end of one rod</source>
        <translation>&amp;Верхняя головка одного шатуна</translation>
    </message>
    <message>
        <source>&amp;Big end of one rod</source>
        <translation>&amp;Нижняя головка одного шатуна</translation>
    </message>
    <message>
        <source>No slug of ⌀ %1 fits at %2.</source>
        <translation>Вставка ⌀ %1 не помещается под углом %2.</translation>
    </message>
    <message>
        <source>Too deep: the maximum depth is %1.</source>
        <translation>Слишком глубоко: максимальная глубина %1.</translation>
    </message>
    <message>
        <source>Too deep: no wall remains to the other holes.</source>
        <translation>Слишком глубоко: стенки до других отверстий не остаётся.</translation>
    </message>
    <message>
        <source>The hole is outside the drilling sector.</source>
        <translation>Отверстие вне сектора сверления.</translation>
    </message>
    <message>
        <source>Another hole is too near.</source>
        <translation>Слишком близко другое отверстие.</translation>
    </message>
    <message>
        <source>Even the shortest slug of ⌀ %1 adds too much.</source>
        <translation>Даже самая короткая вставка ⌀ %1 добавляет слишком много.</translation>
    </message>
    <message>
        <source>Six in line</source>
        <translation>Рядный шестицилиндровый</translation>
    </message>
    <message>
        <source>No hole is possible.</source>
        <translation>Сверлить негде.</translation>
    </message>
    <message>
        <source>Given &amp;as</source>
        <translation>З&amp;аданы</translation>
    </message>
    <message>
        <source>C&amp;rank P₁</source>
        <translation>Кр&amp;ивошип P₁</translation>
    </message>
    <message>
        <source>Ro&amp;d P₂</source>
        <translation>&amp;Шатун P₂</translation>
    </message>
    <message>
        <source>S&amp;lider P₃</source>
        <translation>П&amp;олзун P₃</translation>
    </message>
    <message>
        <source>C&amp;rank m₁</source>
        <translation>Кр&amp;ивошип m₁</translation>
    </message>
    <message>
        <source>Ro&amp;d m₂</source>
        <translation>&amp;Шатун m₂</translation>
    </message>
    <message>
        <source>S&amp;lider m₃</source>
        <translation>П&amp;олзун m₃</translation>
    </message>
    <message>
        <source>&amp;Gravity g</source>
        <translation>Ускорение &amp;g</translation>
    </message>
    <message>
        <source>Ratio λ</source>
        <translation>Отношение λ</translation>
    </message>
    <message>
        <source>Crank speed</source>
        <translation>Угловая скорость</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>точная</translation>
    </message>
    <message>
        <source>paper&apos;s series</source>
        <translation>ряд статьи</translation>
    </message>
    <message>
        <source>&amp;Kinematics of M₁₂</source>
        <translation>Кинема&amp;тика M₁₂</translation>
    </message>
    <message>
        <source>keeps the energy</source>
        <translation>сохраняет энергию</translation>
    </message>
    <message>
        <source>as printed (1)</source>
        <translation>как в (1)</translation>
    </message>
    <message>
        <source>Sign of the g&amp;uide</source>
        <translation>&amp;Знак направляющей</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Жёсткость</translation>
    </message>
    <message>
        <source>&amp;Free length ℓ₀</source>
        <translation>Свобо&amp;дная длина ℓ₀</translation>
    </message>
    <message>
        <source>Guide radius ρ₀</source>
        <translation>Радиус направляющей ρ₀</translation>
    </message>
    <message>
        <source>Own spring for the rod&apos;s &amp;hinge</source>
        <translation>Своя пр&amp;ужина у шатуна</translation>
    </message>
    <message>
        <source>Its &amp;stiffness c</source>
        <translation>Её &amp;жёсткость c</translation>
    </message>
    <message>
        <source>Its free length &amp;ℓ₀</source>
        <translation>Её своб. длина &amp;ℓ₀</translation>
    </message>
    <message>
        <source>Its radius ρ&amp;₀</source>
        <translation>Её радиус ρ&amp;₀</translation>
    </message>
    <message>
        <source>Counter&amp;weight beyond the crankpin</source>
        <translation>Противовес за ше&amp;йкой</translation>
    </message>
    <message>
        <source>Counterweight&apos;s distance</source>
        <translation>Расстояние противовеса</translation>
    </message>
    <message>
        <source>Weight P&amp;₄</source>
        <translation>Вес P&amp;₄</translation>
    </message>
    <message>
        <source>by (10)</source>
        <translation>по (10)</translation>
    </message>
    <message>
        <source>Mass m&amp;₄</source>
        <translation>Масса m&amp;₄</translation>
    </message>
    <message>
        <source>as printed (9)</source>
        <translation>как в (9)</translation>
    </message>
    <message>
        <source>Newton–Euler</source>
        <translation>Ньютон–Эйлер</translation>
    </message>
    <message>
        <source>&amp;Inertia in M₁₂</source>
        <translation>Инерци&amp;я в M₁₂</translation>
    </message>
    <message>
        <source>Roller radi&amp;us</source>
        <translation>Радиус ро&amp;лика</translation>
    </message>
    <message>
        <source>Profile error</source>
        <translation>Погрешность профиля</translation>
    </message>
    <message>
        <source>Error &amp;waves</source>
        <translation>Чис&amp;ло волн погрешности</translation>
    </message>
    <message>
        <source>R&amp;elief</source>
        <translation>Пере&amp;пад</translation>
    </message>
    <message>
        <source>&amp;Outer diameter</source>
        <translation>&amp;Наружный диаметр</translation>
    </message>
    <message>
        <source>&amp;Shortest spring</source>
        <translation>&amp;Кратчайшая пружина</translation>
    </message>
    <message>
        <source>0.4 ℓ₀</source>
        <translation>0,4 ℓ₀</translation>
    </message>
    <message>
        <source>Tur&amp;ns</source>
        <translation>О&amp;бороты</translation>
    </message>
    <message>
        <source>Turns of the crank to compute</source>
        <translation>Сколько оборотов кривошипа рассчитать</translation>
    </message>
    <message>
        <source>Off-design sp&amp;eed</source>
        <translation>Нерасчётная &amp;ω</translation>
    </message>
    <message>
        <source>1.2 ω</source>
        <translation>1,2 ω</translation>
    </message>
    <message>
        <source>S&amp;tart angle</source>
        <translation>На&amp;чальный угол</translation>
    </message>
    <message>
        <source>Crank angle at which the motion starts</source>
        <translation>Угол кривошипа, с которого начинается движение</translation>
    </message>
    <message>
        <source>&amp;Moment on the crank</source>
        <translation>&amp;Момент на кривошипе</translation>
    </message>
    <message>
        <source>A constant moment that drives the crank; negative brakes it</source>
        <translation>Постоянный момент, вращающий кривошип; отрицательный — тормозит</translation>
    </message>
    <message>
        <source>With the profile &amp;error</source>
        <translation>С погр&amp;ешностью профиля</translation>
    </message>
    <message>
        <source>Chord to&amp;lerance</source>
        <translation>До&amp;пуск хорды</translation>
    </message>
    <message>
        <source>S&amp;tep of the table</source>
        <translation>Ша&amp;г таблицы</translation>
    </message>
    <message>
        <source>CSV: step of the crank angle</source>
        <translation>CSV: шаг угла кривошипа</translation>
    </message>
    <message>
        <source>the crank&apos;s hinge</source>
        <translation>шарнир кривошипа</translation>
    </message>
    <message>
        <source>the rod&apos;s hinge</source>
        <translation>шарнир шатуна</translation>
    </message>
    <message>
        <source>no spring is given for %1</source>
        <translation>не задана пружина: %1</translation>
    </message>
    <message>
        <source>chord tolerance</source>
        <translation>допуск хорды</translation>
    </message>
    <message>
        <source>roller radius</source>
        <translation>радиус ролика</translation>
    </message>
    <message>
        <source>must be less than %1, else the profile is undercut</source>
        <translation>должен быть меньше %1, иначе профиль подрезается</translation>
    </message>
    <message>
        <source>a stretched spring of %1 with a relief of %2 needs an outer diameter of at least %3</source>
        <translation>растянутой пружине %1 с перепадом %2 нужен наружный диаметр не меньше %3</translation>
    </message>
    <message>
        <source>must together be more than 0</source>
        <translation>в сумме должно быть больше 0</translation>
    </message>
    <message>
        <source>must be less than 1 for a motion: the mechanism locks</source>
        <translation>для движения должно быть меньше 1: механизм заклинивает</translation>
    </message>
    <message>
        <source>must give the crank and the rod together some mass for a motion</source>
        <translation>для движения у кривошипа с шатуном должна быть масса</translation>
    </message>
    <message>
        <source>the crank made only %1 turns in %2</source>
        <translation>кривошип сделал только %1 оборота за %2</translation>
    </message>
    <message>
        <source>Weights of crank, rod and slider.</source>
        <translation>Веса кривошипа, шатуна и ползуна.</translation>
    </message>
    <message>
        <source>Masses of crank, rod and slider, instead of weights.</source>
        <translation>Массы кривошипа, шатуна и ползуна вместо весов.</translation>
    </message>
    <message>
        <source>The spring of the crank&apos;s hinge.</source>
        <translation>Пружина шарнира кривошипа.</translation>
    </message>
    <message>
        <source>Angle of the rod</source>
        <translation>Угол шатуна</translation>
    </message>
    <message>
        <source>λ = r/ℓ, ℓ length of the rod</source>
        <translation>λ = r/ℓ, ℓ — длина шатуна</translation>
    </message>
    <message>
        <source>Moment on the rod that makes the side force zero</source>
        <translation>Момент на шатуне, обращающий боковую силу в нуль</translation>
    </message>
    <message>
        <source>h₁ = ℓ cos ψ, h₂ = ℓ sin ψ, h₃ = h₁/2, h₄ = ½ r sin φ, I₂ = (P₂/g) ℓ²/12, ε₂ = −d²ψ/dt²; a acceleration, B slider pin, C middle of the rod</source>
        <translation>h₁ = ℓ cos ψ, h₂ = ℓ sin ψ, h₃ = h₁/2, h₄ = ½ r sin φ, I₂ = (P₂/g) ℓ²/12, ε₂ = −d²ψ/dt²; a — ускорение, B — палец ползуна, C — середина шатуна</translation>
    </message>
    <message>
        <source>Part of the counterweight in M₁₂</source>
        <translation>Доля противовеса в M₁₂</translation>
    </message>
    <message>
        <source>P₄ weight at the distance ℓ₂ beyond the crankpin: the mean of M₁₂ over a turn is zero</source>
        <translation>P₄ — вес груза на расстоянии ℓ₂ за шатунной шейкой: среднее M₁₂ за оборот равно нулю</translation>
    </message>
    <message>
        <source>Potential part of M₁₂</source>
        <translation>Потенциальная часть M₁₂</translation>
    </message>
    <message>
        <source>Side force with the rod&apos;s hinge</source>
        <translation>Боковая сила с шарниром шатуна</translation>
    </message>
    <message>
        <source>by virtual power; the paper prints a factor ½ that does not belong to M₁₂</source>
        <translation>по виртуальной мощности; статья печатает множитель ½, который к M₁₂ не относится</translation>
    </message>
    <message>
        <source>Moment that keeps the crank&apos;s speed</source>
        <translation>Момент, сохраняющий скорость кривошипа</translation>
    </message>
    <message>
        <source>Energy of the spring</source>
        <translation>Энергия пружины</translation>
    </message>
    <message>
        <source>c stiffness, ℓ₀ free length, ρ polar radius of the guide; the paper prints +, only − keeps the speed</source>
        <translation>c — жёсткость, ℓ₀ — свободная длина, ρ — полярный радиус направляющей; статья печатает +, скорость сохраняет только −</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Направляющая</translation>
    </message>
    <message>
        <source>B = ℓ₀²/4 − Π/(2c): − of a compressed spring, + of a stretched one</source>
        <translation>B = ℓ₀²/4 − Π/(2c): − у сжатой пружины, + у растянутой</translation>
    </message>
    <message>
        <source>ε amplitude, n waves in a turn</source>
        <translation>ε — амплитуда, n — волн за оборот</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Движение</translation>
    </message>
    <message>
        <source>solved by the energy at every angle; ′ by φ, on the right the constant moment on the crank</source>
        <translation>решается по энергии при каждом угле; ′ — по φ, справа — постоянный момент на кривошипе</translation>
    </message>
    <message>
        <source>Friction, and play in the joints.</source>
        <translation>Трение и зазоры в шарнирах.</translation>
    </message>
    <message>
        <source>The mass of springs and rollers, and the inertia of the hinges themselves.</source>
        <translation>Масса пружин и роликов, инерция самих упругих шарниров.</translation>
    </message>
    <message>
        <source>Gas forces on the slider.</source>
        <translation>Силы газов на ползун.</translation>
    </message>
    <message>
        <source>at lambda = 1 the mechanism locks</source>
        <translation>при λ = 1 механизм заклинивает</translation>
    </message>
    <message>
        <source>Zotov and Sviridov 2021</source>
        <translation>Зотов и Свиридов 2021</translation>
    </message>
    <message>
        <source>ω; the page compares it with 1.2 ω</source>
        <translation>ω; модуль сравнивает её с 1,2 ω</translation>
    </message>
    <message>
        <source>%1: none, because %2.</source>
        <translation>%1: нет, потому что %2.</translation>
    </message>
    <message>
        <source>%1: a roller of radius %2 undercuts it; the maximum is %3.</source>
        <translation>%1: ролик радиусом %2 подрезает её; предел — %3.</translation>
    </message>
    <message>
        <source>%1: cannot be made, its relief is %2, and a profile error of %3 changes the moment by up to %4.</source>
        <translation>%1: изготовить нельзя, перепад %2, а погрешность профиля %3 меняет момент на величину до %4.</translation>
    </message>
    <message>
        <source>%1: feasible, relief %2; a profile error of %3 changes the moment by up to %4.</source>
        <translation>%1: осуществима, перепад %2; погрешность профиля %3 меняет момент на величину до %4.</translation>
    </message>
    <message>
        <source>The preload exceeds the minimum by only %1 of %2.</source>
        <translation>Преднатяг превышает минимальный всего на %1 из %2.</translation>
    </message>
    <message>
        <source>The roller radius is 0: the guide is the path of the roller&apos;s centre.</source>
        <translation>Радиус ролика равен 0: направляющая — траектория центра ролика.</translation>
    </message>
    <message>
        <source>The two rollers overlap (%1): diameter %2, minimum distance of their centres %3. Rollers and spring need separate planes.</source>
        <translation>Ролики перекрываются (%1): диаметр %2, минимальное расстояние между центрами %3. Роликам и пружине нужны разные плоскости.</translation>
    </message>
    <message>
        <source>The spring is compressed from %1 to %2; minimum length: %3.</source>
        <translation>Пружина сжата с %1 до %2; минимальная длина — %3.</translation>
    </message>
    <message>
        <source>%1: the spring cannot be compressed from %2 to %3; minimum length: %4.</source>
        <translation>%1: пружину нельзя сжать с %2 до %3; минимальная длина — %4.</translation>
    </message>
    <message>
        <source>∮ M₁₂ dφ</source>
        <translation>∮ M₁₂ dφ</translation>
    </message>
    <message>
        <source>Counterweight P₄</source>
        <translation>Противовес P₄</translation>
    </message>
    <message>
        <source>Balancing weight</source>
        <translation>Уравновешивающий вес</translation>
    </message>
    <message>
        <source>Crank guide</source>
        <translation>Направляющая кривошипа</translation>
    </message>
    <message>
        <source>Rod hinge guide</source>
        <translation>Направляющая шатуна</translation>
    </message>
    <message>
        <source>Proposed guide</source>
        <translation>Предлагаемая направляющая</translation>
    </message>
    <message>
        <source>Side force</source>
        <translation>Боковая сила</translation>
    </message>
    <message>
        <source>Series against exact</source>
        <translation>Ряд и точная кинематика</translation>
    </message>
    <message>
        <source>Preload</source>
        <translation>Преднатяг</translation>
    </message>
    <message>
        <source>|ℓ₀/2 − ρ₀| of the spring.</source>
        <translation>|ℓ₀/2 − ρ₀| пружины.</translation>
    </message>
    <message>
        <source>Minimum preload</source>
        <translation>Минимальный преднатяг</translation>
    </message>
    <message>
        <source>Minimum stiffness</source>
        <translation>Минимальная жёсткость</translation>
    </message>
    <message>
        <source>Guide ends at φ</source>
        <translation>Направляющая обрывается при φ</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>Ветвь</translation>
    </message>
    <message>
        <source>Relief of the guide</source>
        <translation>Перепад направляющей</translation>
    </message>
    <message>
        <source>Spring travel</source>
        <translation>Ход пружины</translation>
    </message>
    <message>
        <source>Spring compressed</source>
        <translation>Пружина сжата</translation>
    </message>
    <message>
        <source>Spring stretched</source>
        <translation>Пружина растянута</translation>
    </message>
    <message>
        <source>Minimum ρ</source>
        <translation>Минимум ρ</translation>
    </message>
    <message>
        <source>Maximum ρ</source>
        <translation>Максимум ρ</translation>
    </message>
    <message>
        <source>Minimum curvature radius</source>
        <translation>Радиус кривизны, мин.</translation>
    </message>
    <message>
        <source>Undercut</source>
        <translation>Подрез</translation>
    </message>
    <message>
        <source>Minimum profile radius</source>
        <translation>Радиус профиля, мин.</translation>
    </message>
    <message>
        <source>Maximum profile radius</source>
        <translation>Радиус профиля, макс.</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Амплитуда</translation>
    </message>
    <message>
        <source>Waves</source>
        <translation>Волны</translation>
    </message>
    <message>
        <source>Moment error</source>
        <translation>Погрешность момента</translation>
    </message>
    <message>
        <source>Moment error, share</source>
        <translation>Погрешность момента, доля</translation>
    </message>
    <message>
        <source>Energy error</source>
        <translation>Погрешность энергии</translation>
    </message>
    <message>
        <source>Hinge angle θ</source>
        <translation>Угол шарнира θ</translation>
    </message>
    <message>
        <source>ρ, spring compressed</source>
        <translation>ρ, пружина сжата</translation>
    </message>
    <message>
        <source>ρ, spring stretched</source>
        <translation>ρ, пружина растянута</translation>
    </message>
    <message>
        <source>Spring</source>
        <translation>Пружина</translation>
    </message>
    <message>
        <source>Stiffness c</source>
        <translation>Жёсткость c</translation>
    </message>
    <message>
        <source>Free length ℓ₀</source>
        <translation>Свободная длина ℓ₀</translation>
    </message>
    <message>
        <source>Outer diameter</source>
        <translation>Наружный диаметр</translation>
    </message>
    <message>
        <source>Side force, no hinge</source>
        <translation>Бок. сила без шарнира</translation>
    </message>
    <message>
        <source>Side force, rod hinge</source>
        <translation>Бок. сила с шарниром</translation>
    </message>
    <message>
        <source>Side force by Newton–Euler</source>
        <translation>Боковая сила по Ньютону–Эйлеру</translation>
    </message>
    <message>
        <source>Side force, reduction factor</source>
        <translation>Боковая сила, кратность снижения</translation>
    </message>
    <message>
        <source>Without hinge</source>
        <translation>Без шарнира</translation>
    </message>
    <message>
        <source>Crank hinge</source>
        <translation>Шарнир кривошипа</translation>
    </message>
    <message>
        <source>Both hinges</source>
        <translation>Оба шарнира</translation>
    </message>
    <message>
        <source>End of the motion</source>
        <translation>Конец движения</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Время</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Угловая скорость</translation>
    </message>
    <message>
        <source>Mean speed</source>
        <translation>Средняя скорость</translation>
    </message>
    <message>
        <source>Minimum speed</source>
        <translation>Минимальная скорость</translation>
    </message>
    <message>
        <source>Maximum speed</source>
        <translation>Максимальная скорость</translation>
    </message>
    <message>
        <source>Speed ripple</source>
        <translation>Неравномерность вращения</translation>
    </message>
    <message>
        <source>(ω_max − ω_min) / mean ω of the free motion.</source>
        <translation>(ω_max − ω_min) к средней ω свободного движения.</translation>
    </message>
    <message>
        <source>Energy drift</source>
        <translation>Уход энергии</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Шаги</translation>
    </message>
    <message>
        <source>Reduced inertia</source>
        <translation>Приведённый момент инерции</translation>
    </message>
    <message>
        <source>Crank hinge moment M</source>
        <translation>Момент шарнира кривошипа M</translation>
    </message>
    <message>
        <source>Rod hinge moment M₁₂</source>
        <translation>Момент шарнира шатуна M₁₂</translation>
    </message>
    <message>
        <source>Rod hinge moment, potential part</source>
        <translation>Момент шарнира шатуна, потенциальная часть</translation>
    </message>
    <message>
        <source>Side force without hinge</source>
        <translation>Боковая сила без шарнира</translation>
    </message>
    <message>
        <source>Side force with hinge</source>
        <translation>Боковая сила с шарниром</translation>
    </message>
    <message>
        <source>Preload &amp;margin</source>
        <translation>Запас пред&amp;натяга</translation>
    </message>
    <message>
        <source>The paper&apos;s series for cos ψ is accurate for small λ only; the exact form needs λ &lt; 1. M and the crank&apos;s guide are always exact.</source>
        <translation>Ряд статьи для cos ψ точен лишь при малых λ; точной форме нужно λ &lt; 1. M и направляющая кривошипа всегда точны.</translation>
    </message>
    <message>
        <source>For constant crank speed the spring releases the energy that the mechanism absorbs: Π = const − (T + V). Equation (1) is printed with a plus.</source>
        <translation>Для постоянной скорости пружина отдаёт энергию, которую поглощает механизм: Π = const − (T + V). Формула (1) напечатана с плюсом.</translation>
    </message>
    <message>
        <source>If off, the rod&apos;s hinge has the same spring as the crank&apos;s hinge</source>
        <translation>Если выключено, у шарнира шатуна такая же пружина, как у кривошипа</translation>
    </message>
    <message>
        <source>Value of the rod hinge&apos;s own spring</source>
        <translation>Значение собственной пружины шарнира шатуна</translation>
    </message>
    <message>
        <source>Radius of the rod hinge&apos;s own guide at θ = 0</source>
        <translation>Радиус направляющей самого шарнира шатуна при θ = 0</translation>
    </message>
    <message>
        <source>Counterweight at the distance ℓ₂ beyond the crankpin (slider above). With the weight of (10) the rod&apos;s hinge makes the side force zero.</source>
        <translation>Противовес на расстоянии ℓ₂ за шатунной шейкой (ползунок выше). С весом по (10) шарнир шатуна обращает боковую силу в нуль.</translation>
    </message>
    <message>
        <source>solved from (10), P₄ ℓ₂ = (P₃ + P₂/2) ℓ, for zero mean of M₁₂</source>
        <translation>находится из (10), P₄ ℓ₂ = (P₃ + P₂/2) ℓ, при нулевом среднем M₁₂</translation>
    </message>
    <message>
        <source>Equation (9) as printed has the wrong sign of the counterweight&apos;s inertia forces; Newton–Euler makes the side force zero.</source>
        <translation>В напечатанной формуле (9) неверен знак сил инерции противовеса; «Ньютон–Эйлер» обращает боковую силу в нуль.</translation>
    </message>
    <message>
        <source>ρ is the path of the roller&apos;s centre; the profile is offset by the roller&apos;s radius. Paper: 0.</source>
        <translation>ρ — путь центра ролика; профиль смещён на радиус ролика. В статье 0.</translation>
    </message>
    <message>
        <source>Amplitude of the waves of the manufactured profile. Good grinding: a few micrometres.</source>
        <translation>Амплитуда волн изготовленного профиля. Хорошее шлифование: несколько микрометров.</translation>
    </message>
    <message>
        <source>Number of error waves in one turn, a whole number: 1 is an eccentric guide, 2 an oval guide.</source>
        <translation>Число волн погрешности за оборот, целое: 1 — эксцентричность, 2 — овальность.</translation>
    </message>
    <message>
        <source>Search for a spring with a feasible guide.</source>
        <translation>Поиск пружины с допустимой направляющей.</translation>
    </message>
    <message>
        <source>Maximum minus minimum radius of the guide</source>
        <translation>Максимальный радиус направляющей минус минимальный</translation>
    </message>
    <message>
        <source>Guide and rollers must fit in this diameter</source>
        <translation>В этот диаметр должны поместиться направляющая и ролики</translation>
    </message>
    <message>
        <source>Minimum length of the spring (solid length).</source>
        <translation>Минимальная длина пружины (витки сомкнуты).</translation>
    </message>
    <message>
        <source>Preload beyond the guide&apos;s minimum.</source>
        <translation>Преднатяг сверх минимального для направляющей.</translation>
    </message>
    <message>
        <source>Motion, by integration.</source>
        <translation>Движение, интегрированием.</translation>
    </message>
    <message>
        <source>Start speed for comparison with the design speed ω, the only speed at which the hinge is exact.</source>
        <translation>Начальная скорость для сравнения с расчётной ω, единственной, при которой шарнир точен.</translation>
    </message>
    <message>
        <source>Uses the manufactured guide, with the waves of the profile error</source>
        <translation>Учитывает изготовленную направляющую, с волнами погрешности профиля</translation>
    </message>
    <message>
        <source>DXF: maximum distance of the polyline from the curve</source>
        <translation>DXF: максимальное отклонение ломаной от кривой</translation>
    </message>
    <message>
        <source>h₅ = ℓ₂ cos ψ, h₆ = ℓ₂ sin ψ, a acceleration; the paper prints + before both inertia terms, correct is −</source>
        <translation>h₅ = ℓ₂ cos ψ, h₆ = ℓ₂ sin ψ, a — ускорение; статья печатает + перед обоими инерционными членами, верен −</translation>
    </message>
    <message>
        <source>Side force without the hinge</source>
        <translation>Боковая сила без шарнира</translation>
    </message>
    <message>
        <source>Moment on the crank with the rod&apos;s hinge</source>
        <translation>Момент на кривошипе с шарниром шатуна</translation>
    </message>
    <message>
        <source>T kinetic and V potential energy, I reduced inertia, P₁ and P₂ weights of crank and rod, φ crank angle from the slider line</source>
        <translation>T — кинетическая и V — потенциальная энергия, I — приведённый момент инерции, P₁ и P₂ — вес кривошипа и шатуна, φ — угол кривошипа от линии ползуна</translation>
    </message>
    <message>
        <source>the spring must store the energy that the mechanism absorbs; 0: at φ = 0</source>
        <translation>пружина должна запасти энергию, которую поглощает механизм; 0 — при φ = 0</translation>
    </message>
    <message>
        <source>Moment due to a profile error</source>
        <translation>Момент от погрешности профиля</translation>
    </message>
    <message>
        <source>the crank&apos;s hinge with the rod&apos;s hinge</source>
        <translation>шарнир кривошипа при шарнире шатуна</translation>
    </message>
    <message>
        <source>from a crank angle of %1 the spring stores too little energy (worst at %2): the preload |ℓ₀/2 − ρ₀| is %3, the minimum %4</source>
        <translation>начиная с угла кривошипа %1 энергии пружины не хватает (хуже всего при&#xa0;%2): преднатяг |ℓ₀/2 − ρ₀| равен %3, минимум %4</translation>
    </message>
    <message>
        <source>%1; with this preload the minimum stiffness is %2</source>
        <translation>%1; при этом преднатяге минимальная жёсткость %2</translation>
    </message>
    <message>
        <source>at λ = 1 the mechanism locks at a crank angle of 90°: no guide and no motion, only M₁₂ and side force by the series</source>
        <translation>при λ = 1 механизм заклинивает при угле кривошипа 90°: направляющей и движения нет, только M₁₂ и боковая сила по ряду</translation>
    </message>
    <message>
        <source>the spring would be compressed by %1, its whole free length (%2) or more</source>
        <translation>пружина была бы сжата на %1, на всю свободную длину (%2) или больше</translation>
    </message>
    <message>
        <source>no feasible guide</source>
        <translation>допустимой направляющей нет</translation>
    </message>
    <message>
        <source>no feasible guide: %1</source>
        <translation>допустимой направляющей нет: %1</translation>
    </message>
    <message>
        <source>is too small for this guide: more than %1 points</source>
        <translation>слишком мало для этой направляющей: больше %1 точек</translation>
    </message>
    <message>
        <source>at λ = 1 the mechanism locks: no guide</source>
        <translation>при λ = 1 механизм заклинивает: направляющей нет</translation>
    </message>
    <message>
        <source>the hinge releases no energy: its guide is a circle</source>
        <translation>шарнир не отдаёт энергии: его направляющая — окружность</translation>
    </message>
    <message>
        <source>a spring of %1 with a minimum length of %2 has no room for a relief of %3; it must be at least %4 long</source>
        <translation>у пружины %1 с минимальной длиной %2 нет места для перепада %3; она должна быть не короче %4</translation>
    </message>
    <message>
        <source>a compressed spring of %1 with a minimum length of %2 needs an outer diameter of at least %3 for a relief of %4</source>
        <translation>сжатой пружине %1 с минимальной длиной %2 для перепада %4 нужен наружный диаметр не меньше %3</translation>
    </message>
    <message>
        <source>a roller of radius %1 undercuts every guide with a relief of %2: use a smaller roller or less relief</source>
        <translation>ролик радиусом %1 подрезает любую направляющую с перепадом %2; нужен меньший ролик или меньший перепад</translation>
    </message>
    <message>
        <source>the required stiffness, %1, is out of range</source>
        <translation>нужная жёсткость %1 вне допустимых пределов</translation>
    </message>
    <message>
        <source>must be less than 1 for the exact kinematics (else the mechanism locks at a crank angle of 90°; &quot;kinematics&quot;: &quot;series&quot; draws the paper&apos;s curves)</source>
        <translation>для точной кинематики должно быть меньше 1 (иначе механизм заклинивает при угле 90°; кривые статьи чертит &quot;kinematics&quot;: &quot;series&quot;)</translation>
    </message>
    <message>
        <source>must be further from 1 for a motion: more than %1 points</source>
        <translation>для движения должно быть дальше от 1: больше %1 точек</translation>
    </message>
    <message>
        <source>must be less for this motion: %1 points reach only turn %2</source>
        <translation>должно быть меньше для этого движения: %1 точек хватает лишь до оборота %2</translation>
    </message>
    <message>
        <source>must give a feasible guide for this motion: %1</source>
        <translation>для этого движения направляющая должна быть допустимой: %1</translation>
    </message>
    <message>
        <source>the crank stops after %1 turns and reverses</source>
        <translation>через %1 оборота кривошип останавливается и поворачивает назад</translation>
    </message>
    <message>
        <source>the crank is at rest</source>
        <translation>кривошип неподвижен</translation>
    </message>
    <message>
        <source>Work of the rod hinge&apos;s moment over a turn; 0 if a spring can supply it.</source>
        <translation>Работа момента шарнира шатуна за оборот; 0, если её может дать пружина.</translation>
    </message>
    <message>
        <source>Weight on the rod for ∮ M₁₂ dφ = 0, or as entered.</source>
        <translation>Вес груза на шатуне при ∮ M₁₂ dφ = 0 или заданный.</translation>
    </message>
    <message>
        <source>Crank guide with the rod hinge</source>
        <translation>Кривошип с шарниром</translation>
    </message>
    <message>
        <source>Minimum |ℓ₀/2 − ρ₀| to store the energy.</source>
        <translation>Минимум |ℓ₀/2 − ρ₀|, чтобы запасти энергию.</translation>
    </message>
    <message>
        <source>φ of the maximum energy</source>
        <translation>φ максимальной энергии</translation>
    </message>
    <message>
        <source>Maximum minus minimum radius of the guide.</source>
        <translation>Максимальный радиус направляющей минус минимальный.</translation>
    </message>
    <message>
        <source>Maximum minus minimum length of the spring over a turn.</source>
        <translation>Максимальная длина пружины за оборот минус минимальная.</translation>
    </message>
    <message>
        <source>Maximum spring force</source>
        <translation>Сила пружины, макс.</translation>
    </message>
    <message>
        <source>c |ℓ − ℓ₀|, maximum over a turn.</source>
        <translation>c |ℓ − ℓ₀|, максимум за оборот.</translation>
    </message>
    <message>
        <source>Minimum spring force</source>
        <translation>Сила пружины, мин.</translation>
    </message>
    <message>
        <source>Maximum moment</source>
        <translation>Максимальный момент</translation>
    </message>
    <message>
        <source>Radius of curvature of the guide; a cutter must be smaller.</source>
        <translation>Радиус кривизны направляющей; фреза должна быть меньше.</translation>
    </message>
    <message>
        <source>Maximum roller radius</source>
        <translation>Радиус ролика, макс.</translation>
    </message>
    <message>
        <source>Maximum radius of a roller that touches the whole guide.</source>
        <translation>Максимальный радиус ролика, который касается всей направляющей.</translation>
    </message>
    <message>
        <source>Maximum pressure angle</source>
        <translation>Угол давления, макс.</translation>
    </message>
    <message>
        <source>Maximum error of the hinge&apos;s moment at this profile error.</source>
        <translation>Максимальная погрешность момента шарнира при этой погрешности профиля.</translation>
    </message>
    <message>
        <source>Moment error over the hinge&apos;s maximum moment.</source>
        <translation>Отношение погрешности момента к максимальному моменту шарнира.</translation>
    </message>
    <message>
        <source>Minimum spring length</source>
        <translation>Длина пружины, мин.</translation>
    </message>
    <message>
        <source>Maximum spring energy</source>
        <translation>Энергия пружины, макс.</translation>
    </message>
    <message>
        <source>Maximum force of the slider on its guide.</source>
        <translation>Максимальная сила ползуна на направляющую.</translation>
    </message>
    <message>
        <source>Maximum force of the slider on its guide with the rod hinge.</source>
        <translation>Максимальная сила ползуна на направляющую с шарниром шатуна.</translation>
    </message>
    <message>
        <source>Maximum error of cos ψ</source>
        <translation>Максимальная погрешность cos ψ</translation>
    </message>
    <message>
        <source>φ of the maximum error</source>
        <translation>φ максимальной погрешности</translation>
    </message>
    <message>
        <source>Maximum error of M₁₂</source>
        <translation>Максимальная погрешность M₁₂</translation>
    </message>
    <message>
        <source>Crank hinge moment with the rod hinge</source>
        <translation>Момент шарнира кривошипа при шарнире шатуна</translation>
    </message>
    <message>
        <source>no spring is given: enter its free length</source>
        <translation>пружина не задана: введите её свободную длину</translation>
    </message>
    <message>
        <source>The sign is as printed in the paper: the crank does not keep its speed.</source>
        <translation>Знак взят как напечатан в статье: кривошип не сохраняет скорость.</translation>
    </message>
    <message>
        <source>has values whose result exceeds the range of numbers; enter realistic values</source>
        <translation>значения дают результат вне пределов чисел; введите реальные значения</translation>
    </message>
    <message>
        <source>Error of the series in cos ψ: %1 at φ = %2°; use the exact kinematics for a design.</source>
        <translation>Погрешность ряда в cos ψ: %1 при φ = %2°; для проекта берите точную кинематику.</translation>
    </message>
    <message>
        <source>The guide has the sign as printed in the paper: the crank leaves its design speed, which the energy sign keeps.</source>
        <translation>Знак направляющей — как напечатан в статье: кривошип уходит от расчётной скорости, которую сохраняет знак по энергии.</translation>
    </message>
    <message>
        <source>Equation (9) as printed has the wrong sign of the counterweight&apos;s inertia: residual side force up to %1, with Newton–Euler zero.</source>
        <translation>В напечатанной формуле (9) неверен знак инерции противовеса: остаточная боковая сила до %1, по Ньютону–Эйлеру нуль.</translation>
    </message>
    <message>
        <source>The crank&apos;s guide has a relief of only %1: a profile error of %2 changes its moment by up to %3; a softer spring gives more relief.</source>
        <translation>Перепад направляющей кривошипа всего %1: погрешность профиля %2 меняет её момент на величину до %3; более мягкая пружина даёт больший перепад.</translation>
    </message>
    <message>
        <source>The crank is a uniform bar of length r.</source>
        <translation>Кривошип — однородный стержень длины r.</translation>
    </message>
    <message>
        <source>The rod is a uniform bar of length r/λ.</source>
        <translation>Шатун — однородный стержень длины r/λ.</translation>
    </message>
    <message>
        <source>The standard value is 9.80665 m/s².</source>
        <translation>Стандартное значение 9,80665 м/с².</translation>
    </message>
    <message>
        <source>From the crank&apos;s axis to the crankpin; the rod is r/λ long.</source>
        <translation>От оси кривошипа до шатунной шейки; длина шатуна r/λ.</translation>
    </message>
    <message>
        <source>Stiffness of the spring of the crank&apos;s hinge. A softer spring gives more relief.</source>
        <translation>Жёсткость пружины шарнира кривошипа. У более мягкой пружины перепад больше.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>From the crankpin to the counterweight on the rod.</source>
        <translation>От шатунной шейки до противовеса на шатуне.</translation>
    </message>
    <message>
        <source>With masses, gravity may be 0 (horizontal mechanism).</source>
        <translation>С массами ускорение может быть 0 (горизонтальный механизм).</translation>
    </message>
    <message>
        <source>All parts that move along the slider line.</source>
        <translation>Всё, что движется по линии ползуна.</translation>
    </message>
    <message>
        <source>Crank radius to rod length, below 1 (1 with the series only).</source>
        <translation>Отношение радиуса кривошипа к длине шатуна, меньше 1 (1 только с рядом).</translation>
    </message>
    <message>
        <source>Design speed of the hinges.</source>
        <translation>Расчётная скорость шарниров.</translation>
    </message>
    <message>
        <source>Unloaded length of the spring of the crank&apos;s hinge.</source>
        <translation>Длина ненапряжённой пружины шарнира кривошипа.</translation>
    </message>
    <message>
        <source>Radius of the guide at φ = 0: below ℓ₀/2 the spring is compressed, above it stretched.</source>
        <translation>Радиус направляющей при φ = 0: меньше ℓ₀/2 — пружина сжата, больше — растянута.</translation>
    </message>
    <message>
        <source>order %1 force</source>
        <translation>порядок %1, сила</translation>
    </message>
    <message>
        <source>order %1 moment</source>
        <translation>порядок %1, момент</translation>
    </message>
    <message>
        <source>order %1 roll moment</source>
        <translation>порядок %1, опрокидывающий момент</translation>
    </message>
    <message>
        <source>%1, horizontal plane</source>
        <translation>%1, горизонтальная плоскость</translation>
    </message>
    <message>
        <source>%1, vertical plane</source>
        <translation>%1, вертикальная плоскость</translation>
    </message>
    <message>
        <source>the mechanism of cylinder %1 locks with the crank at %2 turning forward and at %3 turning back, measured from the cylinder&apos;s axis</source>
        <translation>механизм цилиндра %1 заклинивает при угле кривошипа %2 при вращении вперёд и %3 назад, от оси цилиндра</translation>
    </message>
    <message>
        <source>must be a layout of the library (the nearest is %1)</source>
        <translation>должно быть компоновкой из списка (ближайшая — %1)</translation>
    </message>
    <message>
        <source>must be a layout of the library</source>
        <translation>должно быть компоновкой из списка</translation>
    </message>
    <message>
        <source>&amp;Crank radius R</source>
        <translation>Радиус кривошип&amp;а R</translation>
    </message>
    <message>
        <source>Half the stroke (a little less with offset). Volkswagen VR5: 45 mm.</source>
        <translation>Половина хода (с дезаксажем чуть меньше). Volkswagen VR5: 45 мм.</translation>
    </message>
    <message>
        <source>&amp;λ = R / L</source>
        <translation>&amp;λ = R / L</translation>
    </message>
    <message>
        <source>Speed &amp;n</source>
        <translation>&amp;Частота n</translation>
    </message>
    <message>
        <source>Crankshaft speed; forces and moments grow with its square.</source>
        <translation>Частота вращения; силы и моменты растут как её квадрат.</translation>
    </message>
    <message>
        <source>Re&amp;ciprocating mass</source>
        <translation>Поступательная &amp;масса</translation>
    </message>
    <message>
        <source>R&amp;otating mass</source>
        <translation>Вра&amp;щающаяся масса</translation>
    </message>
    <message>
        <source>Centre of mass &amp;z₀</source>
        <translation>&amp;Центр масс z₀</translation>
    </message>
    <message>
        <source>&amp;Firing order</source>
        <translation>Порядок ра&amp;боты</translation>
    </message>
    <message>
        <source>Axial position, positive towards cylinder 1</source>
        <translation>Положение вдоль вала, положительное в сторону цилиндра 1</translation>
    </message>
    <message>
        <source>Direction of the cylinder&apos;s axis, counter-clockwise from up</source>
        <translation>Направление оси цилиндра, против часовой стрелки от вертикали</translation>
    </message>
    <message>
        <source>Distance of the cylinder&apos;s axis from the crank axis, positive on the counter-clockwise side</source>
        <translation>Дезаксаж: расстояние оси цилиндра от оси вала, положительное в сторону против часовой стрелки</translation>
    </message>
    <message>
        <source>Crankpin, counter-clockwise from crankpin 1</source>
        <translation>Шатунная шейка, против часовой стрелки от шейки 1</translation>
    </message>
    <message>
        <source>Bank an&amp;gle γ</source>
        <translation>Угол развала &amp;γ</translation>
    </message>
    <message>
        <source>&amp;Spacing a</source>
        <translation>&amp;Шаг a</translation>
    </message>
    <message>
        <source>Sta&amp;gger</source>
        <translation>Смещение ря&amp;дов</translation>
    </message>
    <message>
        <source>&amp;Position of cylinder 1</source>
        <translation>П&amp;оложение цилиндра 1</translation>
    </message>
    <message>
        <source>Rod &amp;mass</source>
        <translation>Масса шат&amp;уна</translation>
    </message>
    <message>
        <source>Whole rod</source>
        <translation>Всего шатуна</translation>
    </message>
    <message>
        <source>Centre from &amp;big end</source>
        <translation>Центр от &amp;нижней головки</translation>
    </message>
    <message>
        <source>Centre of mass, from the big end towards the small end</source>
        <translation>Центр масс, от нижней (кривошипной) головки к верхней</translation>
    </message>
    <message>
        <source>&amp;Inertia</source>
        <translation>Момент &amp;инерции</translation>
    </message>
    <message>
        <source>exact orders</source>
        <translation>точные порядки</translation>
    </message>
    <message>
        <source>two-term form</source>
        <translation>два члена</translation>
    </message>
    <message>
        <source>+kω</source>
        <translation>+kω</translation>
    </message>
    <message>
        <source>−kω</source>
        <translation>−kω</translation>
    </message>
    <message>
        <source>moment</source>
        <translation>момент</translation>
    </message>
    <message>
        <source>force</source>
        <translation>сила</translation>
    </message>
    <message>
        <source>&amp;Designed for</source>
        <translation>Рассчитаны &amp;на</translation>
    </message>
    <message>
        <source>Order of the shaft</source>
        <translation>Порядок вала</translation>
    </message>
    <message>
        <source>Direction of the shaft</source>
        <translation>Направление вала</translation>
    </message>
    <message>
        <source>With the crank (+kω) or against it (−kω)</source>
        <translation>По вращению коленчатого вала (+kω) или против (−kω)</translation>
    </message>
    <message>
        <source>Task of the shaft</source>
        <translation>Задача вала</translation>
    </message>
    <message>
        <source>Two opposite weights against a moment, one against a force</source>
        <translation>Два противоположных груза против момента, один против силы</translation>
    </message>
    <message>
        <source>Distance of the shaft&apos;s weights</source>
        <translation>Расстояние между грузами вала</translation>
    </message>
    <message>
        <source>Distance between the two weights along the shaft</source>
        <translation>Расстояние между двумя грузами вдоль вала</translation>
    </message>
    <message>
        <source>Place of the shaft</source>
        <translation>Место вала</translation>
    </message>
    <message>
        <source>c. m.</source>
        <translation>ц. м.</translation>
    </message>
    <message>
        <source>Radius of the shaft&apos;s weights</source>
        <translation>Радиус грузов вала</translation>
    </message>
    <message>
        <source>Phase of the shaft</source>
        <translation>Фаза вала</translation>
    </message>
    <message>
        <source>Shaft on</source>
        <translation>Вал включён</translation>
    </message>
    <message>
        <source>&amp;Front web at z</source>
        <translation>Передняя щека, &amp;z</translation>
    </message>
    <message>
        <source>Axial position of the front weight</source>
        <translation>Положение переднего груза вдоль вала</translation>
    </message>
    <message>
        <source>R&amp;ear web at z</source>
        <translation>&amp;Задняя щека, z</translation>
    </message>
    <message>
        <source>Axial position of the rear weight</source>
        <translation>Положение заднего груза вдоль вала</translation>
    </message>
    <message>
        <source>Front &amp;radius ρ</source>
        <translation>П&amp;ередний радиус ρ</translation>
    </message>
    <message>
        <source>Rear ra&amp;dius ρ</source>
        <translation>З&amp;адний радиус ρ</translation>
    </message>
    <message>
        <source>must list from 1 to %1 cylinders</source>
        <translation>цилиндров должно быть от 1 до %1</translation>
    </message>
    <message>
        <source>sizes, masses and speed together must keep forces and moments under 1e100 N and N·m</source>
        <translation>размеры, массы и частота вращения вместе должны давать силы и моменты меньше 1e100 Н и Н·м</translation>
    </message>
    <message>
        <source>sizes, masses and speed together must keep m R ω² over 1e-100 N</source>
        <translation>размеры, массы и частота вращения вместе должны давать m R ω² больше 1e-100 Н</translation>
    </message>
    <message>
        <source>must list at most %1 shafts</source>
        <translation>валов должно быть не больше %1</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>Одноцилиндровый</translation>
    </message>
    <message>
        <source>In-line 2, 180°</source>
        <translation>Рядный 2, 180°</translation>
    </message>
    <message>
        <source>In-line 2, 360°</source>
        <translation>Рядный 2, 360°</translation>
    </message>
    <message>
        <source>In-line 3</source>
        <translation>Рядный 3</translation>
    </message>
    <message>
        <source>In-line 4</source>
        <translation>Рядный 4</translation>
    </message>
    <message>
        <source>In-line 5</source>
        <translation>Рядный 5</translation>
    </message>
    <message>
        <source>In-line 6</source>
        <translation>Рядный 6</translation>
    </message>
    <message>
        <source>V-twin 45°</source>
        <translation>V2 45°</translation>
    </message>
    <message>
        <source>V-twin 60°</source>
        <translation>V2 60°</translation>
    </message>
    <message>
        <source>V-twin 90°</source>
        <translation>V2 90°</translation>
    </message>
    <message>
        <source>V6 60°, split pins</source>
        <translation>V6 60°, разведённые шейки</translation>
    </message>
    <message>
        <source>V6 90°, split pins</source>
        <translation>V6 90°, разведённые шейки</translation>
    </message>
    <message>
        <source>V8, cross-plane</source>
        <translation>V8, крестообразный вал</translation>
    </message>
    <message>
        <source>V8, flat-plane</source>
        <translation>V8, плоский вал</translation>
    </message>
    <message>
        <source>Flat twin</source>
        <translation>Оппозитный 2</translation>
    </message>
    <message>
        <source>Flat 4</source>
        <translation>Оппозитный 4</translation>
    </message>
    <message>
        <source>Flat 6</source>
        <translation>Оппозитный 6</translation>
    </message>
    <message>
        <source>VR5</source>
        <translation>VR5</translation>
    </message>
    <message>
        <source>VR6</source>
        <translation>VR6</translation>
    </message>
    <message>
        <source>W12</source>
        <translation>W12</translation>
    </message>
    <message>
        <source>must name each cylinder from 1 to %1 once</source>
        <translation>должно назвать каждый цилиндр от 1 до %1 один раз</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>ничего</translation>
    </message>
    <message>
        <source>R&amp;otating mass of a throw</source>
        <translation>&amp;Вращающаяся масса колена</translation>
    </message>
    <message>
        <source>C&amp;ycle</source>
        <translation>Ц&amp;икл</translation>
    </message>
    <message>
        <source>The cylinders one by one, instead of a layout.</source>
        <translation>Цилиндры по одному, вместо компоновки.</translation>
    </message>
    <message>
        <source>A layout, instead of the cylinders one by one.</source>
        <translation>Компоновка вместо перечня цилиндров.</translation>
    </message>
    <message>
        <source>A VR engine of any number of cylinders, or a layout of the library.</source>
        <translation>VR-двигатель с любым числом цилиндров или компоновка из библиотеки.</translation>
    </message>
    <message>
        <source>Name in the library, for example i4, v6-60, v8-cross-plane.</source>
        <translation>Имя в библиотеке, например i4, v6-60, v8-cross-plane.</translation>
    </message>
    <message>
        <source>Number of cylinders of a VR engine.</source>
        <translation>Число цилиндров VR-двигателя.</translation>
    </message>
    <message>
        <source>The balance shafts, each made for the order that it cancels.</source>
        <translation>Балансирные валы, каждый для порядка, который он уравновешивает.</translation>
    </message>
    <message>
        <source>The two counterweights on the end webs.</source>
        <translation>Два противовеса на крайних щеках.</translation>
    </message>
    <message>
        <source>throws with %1 and with %2 rods</source>
        <translation>колена с числом шатунов %1 и %2</translation>
    </message>
    <message>
        <source>must be a cylinder of the table, 1 to %1</source>
        <translation>должен быть цилиндр таблицы, от 1 до %1</translation>
    </message>
    <message>
        <source>must be less than %1, the length of the master rod</source>
        <translation>должно быть меньше %1 — длины главного шатуна</translation>
    </message>
    <message>
        <source>two strokes, 360°</source>
        <translation>два такта, 360°</translation>
    </message>
    <message>
        <source>four strokes, 720°</source>
        <translation>четыре такта, 720°</translation>
    </message>
    <message>
        <source>Axial position z of cylinder 1. Volkswagen VR5: 3 a + l = 204.8 mm, with the centre of mass at z = 0.</source>
        <translation>Положение z цилиндра 1 вдоль вала. Volkswagen VR5: 3 a + l = 204,8 мм, центр масс при z = 0.</translation>
    </message>
    <message>
        <source>must be at most %1, the rotating mass of one cylinder</source>
        <translation>должно быть не больше %1 — вращающейся массы одного цилиндра</translation>
    </message>
    <message>
        <source>axial position</source>
        <translation>положение вдоль вала</translation>
    </message>
    <message>
        <source>crankpin angle</source>
        <translation>угол шейки</translation>
    </message>
    <message>
        <source>knuckle radius</source>
        <translation>радиус прицепа</translation>
    </message>
    <message>
        <source>knuckle angle</source>
        <translation>угол прицепа</translation>
    </message>
    <message>
        <source>Rod as a rigid body</source>
        <translation>Шатун как твёрдое тело</translation>
    </message>
    <message>
        <source>Ro&amp;d length L</source>
        <translation>&amp;Длина шатуна L</translation>
    </message>
    <message>
        <source>Swing of the master rod</source>
        <translation>Качание главного шатуна</translation>
    </message>
    <message>
        <source>ψ counter-clockwise from the master cylinder&apos;s axis, index m: of the master cylinder</source>
        <translation>ψ — против часовой стрелки от оси главного цилиндра, индекс m — главного цилиндра</translation>
    </message>
    <message>
        <source>Knuckle pin</source>
        <translation>Палец прицепного шатуна</translation>
    </message>
    <message>
        <source>along the cylinder&apos;s own axis + i across it; r_k and γ radius and angle of the knuckle pin, β bank angle</source>
        <translation>вдоль оси самого цилиндра + i поперёк неё; r_k и γ — радиус и угол пальца прицепного шатуна, β — угол ряда</translation>
    </message>
    <message>
        <source>Articulated piston pin</source>
        <translation>Поршневой палец прицепного шатуна</translation>
    </message>
    <message>
        <source>l length of the articulated rod</source>
        <translation>l — длина прицепного шатуна</translation>
    </message>
    <message>
        <source>Rotating parts of order k</source>
        <translation>Вращающиеся части порядка k</translation>
    </message>
    <message>
        <source>A turns with the crank, B against it; each is cancelled by one shaft</source>
        <translation>A вращается с кривошипом, B — против него; каждую уравновешивает один вал</translation>
    </message>
    <message>
        <source>Balance shaft against a moment</source>
        <translation>Балансирный вал против момента</translation>
    </message>
    <message>
        <source>L distance of its two weights; phase opposite to A or B</source>
        <translation>L — расстояние двух его грузов; фаза противоположна A или B</translation>
    </message>
    <message>
        <source>Balance shaft against a force</source>
        <translation>Балансирный вал против силы</translation>
    </message>
    <message>
        <source>Rotating masses</source>
        <translation>Вращающиеся массы</translation>
    </message>
    <message>
        <source>force and moment; κ crankpin angle; two weights on the end webs are opposite to both</source>
        <translation>сила и момент; κ — угол шатунной шейки; два груза на крайних щеках противоположны обоим</translation>
    </message>
    <message>
        <source>Piston pin along its axis</source>
        <translation>Поршневой палец вдоль своей оси</translation>
    </message>
    <message>
        <source>θ = φ + β₁ + κ − β angle of the crankpin from the cylinder&apos;s axis, R crank radius, L = R/λ rod, e = K R offset</source>
        <translation>θ = φ + β₁ + κ − β — угол шатунной шейки от оси цилиндра, R — радиус кривошипа, L = R/λ — шатун, e = K R — дезаксаж</translation>
    </message>
    <message>
        <source>Inertia force, exact</source>
        <translation>Сила инерции, точная</translation>
    </message>
    <message>
        <source>orders 1 to 12 by a Fourier transform of the exact motion</source>
        <translation>порядки с 1 по 12 преобразованием Фурье точного движения</translation>
    </message>
    <message>
        <source>Inertia force, two terms</source>
        <translation>Сила инерции, два члена</translation>
    </message>
    <message>
        <source>Top dead centre</source>
        <translation>Верхняя мёртвая точка</translation>
    </message>
    <message>
        <source>on the side of the offset</source>
        <translation>на стороне дезаксажа</translation>
    </message>
    <message>
        <source>Shift of the second bank&apos;s crankpins</source>
        <translation>Сдвиг шеек второго ряда</translation>
    </message>
    <message>
        <source>for even firing; γ angle between the banks, φ₀ top dead centre. The paper prints γ + φ₀, but its number is from this formula</source>
        <translation>для равномерных вспышек; γ — угол между рядами, φ₀ — верхняя мёртвая точка. В статье напечатано γ + φ₀, но её число — по этой формуле</translation>
    </message>
    <message>
        <source>Force on the engine</source>
        <translation>Сила на двигатель</translation>
    </message>
    <message>
        <source>uᵢ direction of cylinder i</source>
        <translation>uᵢ — направление цилиндра i</translation>
    </message>
    <message>
        <source>Moments in the horizontal and vertical plane</source>
        <translation>Моменты в горизонтальной и вертикальной плоскости</translation>
    </message>
    <message>
        <source>Roll moment</source>
        <translation>Опрокидывающий момент</translation>
    </message>
    <message>
        <source>due to the offset axes and the reaction to the torque on the crank</source>
        <translation>от дезаксажей и как реакция на момент на кривошипе</translation>
    </message>
    <message>
        <source>The engine is rigid, and the crank turns at constant speed.</source>
        <translation>Двигатель жёсткий, вал вращается с постоянной скоростью.</translation>
    </message>
    <message>
        <source>must be greater than the crank radius, %1; %2</source>
        <translation>должно быть больше радиуса кривошипа, %1; %2</translation>
    </message>
    <message>
        <source>must be at most %1, 1e9 times the crank radius</source>
        <translation>должно быть не больше %1, 1e9 радиусов кривошипа</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Компоновка</translation>
    </message>
    <message>
        <source>VR engine</source>
        <translation>двигатель VR</translation>
    </message>
    <message>
        <source>of the library</source>
        <translation>из библиотеки</translation>
    </message>
    <message>
        <source>Kind of layout</source>
        <translation>Вид компоновки</translation>
    </message>
    <message>
        <source>must differ from %1 by more than %2</source>
        <translation>должно отличаться от «%1» больше чем на %2</translation>
    </message>
    <message>
        <source>Radial engine, %1 cylinders</source>
        <translation>Звезда, цилиндров: %1</translation>
    </message>
    <message>
        <source>Articulated rod: distance of its knuckle pin from the crankpin&apos;s centre.</source>
        <translation>Прицепной шатун: расстояние пальца прицепа от центра шейки.</translation>
    </message>
    <message>
        <source>Articulated rod: its knuckle pin about the crankpin, counter-clockwise from the master rod&apos;s axis.</source>
        <translation>Прицепной шатун: угол его пальца прицепа вокруг шейки, против часовой стрелки от оси главного шатуна.</translation>
    </message>
    <message>
        <source>the difference of the bank angles</source>
        <translation>разность углов рядов</translation>
    </message>
    <message>
        <source>Articulated rod: its length from knuckle pin to piston pin.</source>
        <translation>Прицепной шатун: длина от пальца прицепа до поршневого пальца.</translation>
    </message>
    <message>
        <source>Articulated rod: number of the cylinder with its master rod.</source>
        <translation>Прицепной шатун: номер цилиндра с его главным шатуном.</translation>
    </message>
    <message>
        <source>Axial position of the weight.</source>
        <translation>Положение груза вдоль вала.</translation>
    </message>
    <message>
        <source>Radius of the weights&apos; centres of mass; gives their mass.</source>
        <translation>Радиус центров масс грузов; даёт их массу.</translation>
    </message>
    <message>
        <source>only mρ is given</source>
        <translation>известно только mρ</translation>
    </message>
    <message>
        <source>z = 0 in the middle</source>
        <translation>z = 0 посередине</translation>
    </message>
    <message>
        <source>must be at most %1; %2</source>
        <translation>не больше %1; %2</translation>
    </message>
    <message>
        <source>Forces and moments of orders 1 to 4 are balanced.</source>
        <translation>Силы и моменты порядков 1–4 уравновешены.</translation>
    </message>
    <message>
        <source>The shafts are designed by the two-term form, which is inaccurate here: %1.</source>
        <translation>Валы рассчитаны по двучленной формуле, здесь она неточна: %1.</translation>
    </message>
    <message>
        <source>Crankpin angle</source>
        <translation>Угол шейки</translation>
    </message>
    <message>
        <source>From the cylinder&apos;s axis, without sign.</source>
        <translation>От оси цилиндра, без знака.</translation>
    </message>
    <message>
        <source>Crank angle at TDC of each cylinder</source>
        <translation>Угол кривошипа в ВМТ каждого цилиндра</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Ход поршня</translation>
    </message>
    <message>
        <source>Articulated rods</source>
        <translation>Прицепные шатуны</translation>
    </message>
    <message>
        <source>Two-term</source>
        <translation>Двучленная формула</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Точный расчёт</translation>
    </message>
    <message>
        <source>Crank throws</source>
        <translation>Колена вала</translation>
    </message>
    <message>
        <source>Difference of the two-term form</source>
        <translation>Отличие двучленной формулы</translation>
    </message>
    <message>
        <source>Firing order</source>
        <translation>Порядок работы</translation>
    </message>
    <message>
        <source>Firing cycle</source>
        <translation>Цикл вспышек</translation>
    </message>
    <message>
        <source>Even firing</source>
        <translation>Равномерные вспышки</translation>
    </message>
    <message>
        <source>Balance shafts</source>
        <translation>Балансирные валы</translation>
    </message>
    <message>
        <source>Counterweights</source>
        <translation>Противовесы</translation>
    </message>
    <message>
        <source>Before balancing</source>
        <translation>До уравновешивания</translation>
    </message>
    <message>
        <source>Exact orders with the rotating masses.</source>
        <translation>Точные порядки с вращающимися массами.</translation>
    </message>
    <message>
        <source>Residual forces and moments</source>
        <translation>Остаточные силы и моменты</translation>
    </message>
    <message>
        <source>Curves before balancing</source>
        <translation>Кривые до уравновешивания</translation>
    </message>
    <message>
        <source>Residual curves</source>
        <translation>Остаточные кривые</translation>
    </message>
    <message>
        <source>order 1</source>
        <translation>1-й порядок</translation>
    </message>
    <message>
        <source>order 2</source>
        <translation>2-й порядок</translation>
    </message>
    <message>
        <source>order 3</source>
        <translation>3-й порядок</translation>
    </message>
    <message>
        <source>order 4</source>
        <translation>4-й порядок</translation>
    </message>
    <message>
        <source>order 5</source>
        <translation>5-й порядок</translation>
    </message>
    <message>
        <source>order 6</source>
        <translation>6-й порядок</translation>
    </message>
    <message>
        <source>order 7</source>
        <translation>7-й порядок</translation>
    </message>
    <message>
        <source>order 8</source>
        <translation>8-й порядок</translation>
    </message>
    <message>
        <source>order 9</source>
        <translation>9-й порядок</translation>
    </message>
    <message>
        <source>order 10</source>
        <translation>10-й порядок</translation>
    </message>
    <message>
        <source>order 11</source>
        <translation>11-й порядок</translation>
    </message>
    <message>
        <source>order 12</source>
        <translation>12-й порядок</translation>
    </message>
    <message>
        <source>roll moment</source>
        <translation>опрокидывающий момент</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>горизонтально</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>вертикально</translation>
    </message>
    <message>
        <source>from offsets and rods</source>
        <translation>от дезаксажей и шатунов</translation>
    </message>
    <message>
        <source>reaction torque</source>
        <translation>реактивный момент</translation>
    </message>
    <message>
        <source>sum</source>
        <translation>сумма</translation>
    </message>
    <message>
        <source>cosine</source>
        <translation>косинус</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>синус</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>угол</translation>
    </message>
    <message>
        <source>force factor</source>
        <translation>множитель силы</translation>
    </message>
    <message>
        <source>angle of the force</source>
        <translation>угол силы</translation>
    </message>
    <message>
        <source>moment factor about mean z</source>
        <translation>множитель момента относительно средней z</translation>
    </message>
    <message>
        <source>About the mean axial position of the crankpins.</source>
        <translation>Относительно среднего положения шеек вдоль вала.</translation>
    </message>
    <message>
        <source>moment about mean z</source>
        <translation>момент относительно средней z</translation>
    </message>
    <message>
        <source>angle of the moment</source>
        <translation>угол момента</translation>
    </message>
    <message>
        <source>lag of the counterweight against the force</source>
        <translation>отставание противовеса против силы</translation>
    </message>
    <message>
        <source>lag of the counterweights against the moment</source>
        <translation>отставание противовесов против момента</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>цилиндр</translation>
    </message>
    <message>
        <source>master cylinder</source>
        <translation>главный цилиндр</translation>
    </message>
    <message>
        <source>firing interval</source>
        <translation>интервал вспышек</translation>
    </message>
    <message>
        <source>unbalance</source>
        <translation>дисбаланс</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>масса</translation>
    </message>
    <message>
        <source>cancels</source>
        <translation>гасит</translation>
    </message>
    <message>
        <source>maximum before</source>
        <translation>максимум до</translation>
    </message>
    <message>
        <source>maximum after</source>
        <translation>максимум после</translation>
    </message>
    <message>
        <source>front</source>
        <translation>спереди</translation>
    </message>
    <message>
        <source>rear</source>
        <translation>сзади</translation>
    </message>
    <message>
        <source>lag</source>
        <translation>отставание</translation>
    </message>
    <message>
        <source>unbalance against the force</source>
        <translation>дисбаланс против силы</translation>
    </message>
    <message>
        <source>unbalance against the moment</source>
        <translation>дисбаланс против момента</translation>
    </message>
    <message>
        <source>horizontal force</source>
        <translation>горизонтальная сила</translation>
    </message>
    <message>
        <source>vertical force</source>
        <translation>вертикальная сила</translation>
    </message>
    <message>
        <source>moment about x</source>
        <translation>момент вокруг оси x</translation>
    </message>
    <message>
        <source>moment about y</source>
        <translation>момент вокруг оси y</translation>
    </message>
    <message>
        <source>roll moment from offsets and rods</source>
        <translation>опрокидывающий момент от дезаксажей и шатунов</translation>
    </message>
    <message>
        <source>must have a master rod: all rods on the crankpin of cylinder %1 are articulated</source>
        <translation>нужен главный шатун: на шейке цилиндра %1 все шатуны прицепные</translation>
    </message>
    <message>
        <source>must be given: any of the rods of cylinders %1 on this crankpin could be the master</source>
        <translation>должно быть задано: главным на этой шейке может быть любой из шатунов цилиндров %1</translation>
    </message>
    <message>
        <source>must be a rod on the crankpin; the rod of cylinder %1 is articulated too</source>
        <translation>должен быть шатун на шейке; шатун цилиндра %1 тоже прицепной</translation>
    </message>
    <message>
        <source>must run on the same crankpin (same angle, another direction, less than the crank radius away); cylinder %1 runs on the crankpin of cylinders %2</source>
        <translation>должен стоять на той же шейке (тот же угол, другое направление, ближе радиуса кривошипа); цилиндр %1 — на шейке цилиндров %2</translation>
    </message>
    <message>
        <source>The articulated rods of cylinders %1 are longer than the master rod (%2); usual: shorter by about the knuckle radius.</source>
        <translation>Прицепные шатуны цилиндров %1 длиннее главного (%2); обычно короче примерно на радиус прицепа.</translation>
    </message>
    <message>
        <source>%1: not in the two-term form, %2 % of the maximum order</source>
        <translation>%1: в двучленной формуле нет, %2&#xa0;% наибольшего порядка</translation>
    </message>
    <message>
        <source>%1: error of the two-term form %2 %</source>
        <translation>%1: ошибка двучленной формулы %2&#xa0;%</translation>
    </message>
    <message>
        <source>the mechanism of cylinder %1 is not possible: the rod does not reach the piston at any crank angle</source>
        <translation>механизм цилиндра %1 невозможен: шатун не достаёт до поршня ни при каком угле кривошипа</translation>
    </message>
    <message>
        <source>Crank radius over rod length; the crank turns if λ (1 + |e|/R) &lt; 1. Volkswagen VR5: 0.265.</source>
        <translation>Отношение радиуса кривошипа к длине шатуна; вал проворачивается, если λ (1 + |e|/R) &lt; 1. Volkswagen VR5: 0,265.</translation>
    </message>
    <message>
        <source>From crankpin to piston pin. Enter λ or the length; the entered one is kept when the crank radius changes.</source>
        <translation>От шатунной шейки до поршневого пальца. Введите λ или длину; введённое сохраняется при другом радиусе кривошипа.</translation>
    </message>
    <message>
        <source>Mass of one cylinder: piston with pin and rings, and the rod&apos;s share unless the rod is a rigid body. Volkswagen VR5: 0.622 kg.</source>
        <translation>Масса одного цилиндра: поршень с пальцем и кольцами и доля шатуна, если шатун не задан твёрдым телом. Volkswagen VR5: 0,622 кг.</translation>
    </message>
    <message>
        <source>Mass of one cylinder at the crank radius: its part of the throw, and the rod&apos;s share unless the rod is a rigid body. A crankpin with two rods carries it twice.</source>
        <translation>Масса одного цилиндра на радиусе кривошипа: его часть колена и доля шатуна, если шатун не задан твёрдым телом. Шейка с двумя шатунами несёт её дважды.</translation>
    </message>
    <message>
        <source>Rotating mass on one crankpin, with the shares of its rods unless the rod is a rigid body. All crankpins must carry the same number of rods.</source>
        <translation>Вращающаяся масса на одной шейке, с долями её шатунов, если шатун не задан твёрдым телом. На всех шейках должно быть одинаковое число шатунов.</translation>
    </message>
    <message>
        <source>The cylinders fire over 720° (four strokes) or 360° (two strokes). Crankpins for even firing are adjusted.</source>
        <translation>Цилиндры работают за 720° (четыре такта) или 360° (два такта). Шейки для равномерных вспышек пересчитываются.</translation>
    </message>
    <message>
        <source>Axial position of the reference point of moments, positive towards cylinder 1.</source>
        <translation>Положение точки отсчёта моментов вдоль вала, положительное в сторону цилиндра 1.</translation>
    </message>
    <message>
        <source>Step of the curves in the result; without a step there are no curves.</source>
        <translation>Шаг кривых в результате; без шага кривых нет.</translation>
    </message>
    <message>
        <source>Numbers of the cylinders, for example 1-2-4-5-3. Crankpins for even firing are adjusted.</source>
        <translation>Номера цилиндров, например 1-2-4-5-3. Шейки для равномерных вспышек пересчитываются.</translation>
    </message>
    <message>
        <source>The rod is attached to the master rod by a knuckle pin (radials); otherwise it runs on the crankpin.</source>
        <translation>Шатун прицеплен пальцем к главному шатуну (звёзды); иначе он на шейке.</translation>
    </message>
    <message>
        <source>the rod runs on the crankpin</source>
        <translation>шатун на шейке</translation>
    </message>
    <message>
        <source>the master rod&apos;s length minus the knuckle radius</source>
        <translation>длина главного минус радиус прицепа</translation>
    </message>
    <message>
        <source>0, the only rod on the crankpin</source>
        <translation>0, единственный шатун на шейке</translation>
    </message>
    <message>
        <source>Articulated rod: part of the cylinder&apos;s rotating mass at the knuckle pin instead of the crankpin</source>
        <translation>Прицепной шатун: часть вращающейся массы цилиндра, которая находится у пальца прицепа, а не у шейки</translation>
    </message>
    <message>
        <source>Angle between the banks, 0 to 180°. Crankpins for even firing are adjusted; in a table only the bank angles are scaled.</source>
        <translation>Угол между рядами, от 0 до 180°. Шейки для равномерных вспышек пересчитываются; в таблице пропорционально меняются только углы рядов.</translation>
    </message>
    <message>
        <source>Distance of the cylinder axes from the crank axis. In a table: the maximum; the others are scaled.</source>
        <translation>Расстояние осей цилиндров от оси вала. В таблице — максимальное; остальные меняются пропорционально.</translation>
    </message>
    <message>
        <source>Distance along the crank between neighbouring crankpins, or throws of a V engine. Volkswagen VR5: 63 mm.</source>
        <translation>Расстояние вдоль вала между соседними шатунными шейками или коленами V-образного двигателя. Volkswagen VR5: 63 мм.</translation>
    </message>
    <message>
        <source>Distance along the crank from bank 1&apos;s to bank 2&apos;s cylinder of a throw. 0 for forked rods.</source>
        <translation>Расстояние вдоль вала от цилиндра ряда 1 до цилиндра ряда 2 на том же колене. 0 при вильчатых шатунах.</translation>
    </message>
    <message>
        <source>The rod as a rigid body; otherwise its shares are in the masses.</source>
        <translation>Шатун как твёрдое тело; иначе его доли входят в массы.</translation>
    </message>
    <message>
        <source>Moment of inertia about the centre of mass</source>
        <translation>Момент инерции относительно центра масс</translation>
    </message>
    <message>
        <source>The paper designs its shafts by the two-term form; the residual is then the error of this form.</source>
        <translation>В статье валы рассчитаны по двучленной формуле; остаток тогда равен её погрешности.</translation>
    </message>
    <message>
        <source>Order that the shaft cancels; the shaft turns k times as fast as the crank.</source>
        <translation>Порядок, который гасит вал; он вращается в k раз быстрее коленчатого.</translation>
    </message>
    <message>
        <source>at the reference point of moments</source>
        <translation>в точке отсчёта моментов</translation>
    </message>
    <message>
        <source>Phase error of the shaft, positive ahead in its own direction; 0 for correct timing.</source>
        <translation>Ошибка фазы вала, положительная вперёд по его вращению; 0 при верной установке.</translation>
    </message>
    <message>
        <source>If on, the shaft is included in the residual.</source>
        <translation>Включённый вал учитывается в остатке.</translation>
    </message>
    <message>
        <source>Radius of the front weight&apos;s centre of mass</source>
        <translation>Радиус центра масс переднего груза</translation>
    </message>
    <message>
        <source>Radius of the rear weight&apos;s centre of mass</source>
        <translation>Радиус центра масс заднего груза</translation>
    </message>
    <message>
        <source>If on, the counterweights are included in the residual.</source>
        <translation>Включённые противовесы учитываются в остатке.</translation>
    </message>
    <message>
        <source>the paper&apos;s form, compared with the exact one</source>
        <translation>форма статьи, для сравнения с точной</translation>
    </message>
    <message>
        <source>zᵢ place of cylinder i along the crank, z₀ reference point of moments</source>
        <translation>zᵢ — место цилиндра i вдоль вала, z₀ — точка отсчёта моментов</translation>
    </message>
    <message>
        <source>The rod&apos;s centre of mass, %1 from the big end, is outside the rod of %2: check it.</source>
        <translation>Центр масс шатуна в %1 от нижней головки — вне шатуна длиной %2: проверьте.</translation>
    </message>
    <message>
        <source>The stagger of %1 has no effect: no throw has cylinders of two banks.</source>
        <translation>Смещение рядов %1 не действует: ни на одном колене нет цилиндров двух рядов.</translation>
    </message>
    <message>
        <source>The rod&apos;s inertia is implausible: radius of gyration %1, rod %2. Check its unit.</source>
        <translation>Момент инерции шатуна неправдоподобен: радиус инерции %1, шатун %2. Проверьте единицу.</translation>
    </message>
    <message>
        <source>Cylinder spacing %1 is implausible with crank radius %2: check it.</source>
        <translation>Межцилиндровое расстояние %1 неправдоподобно при радиусе кривошипа %2: проверьте.</translation>
    </message>
    <message>
        <source>The centre of mass z₀ is %1 outside the cylinders, with crank radius %2: check it.</source>
        <translation>Центр масс z₀ в %1 за пределами цилиндров при радиусе кривошипа %2: проверьте.</translation>
    </message>
    <message>
        <source>The counterweights at z = %1 and %2 are not beyond the outer cylinders: check their places.</source>
        <translation>Противовесы на z = %1 и %2 стоят не за крайними цилиндрами: проверьте их место.</translation>
    </message>
    <message>
        <source>A counterweight of %1 is heavier than all throws and pistons (%2): check places and radii of the counterweights.</source>
        <translation>Противовес %1 тяжелее всех колен и поршней вместе (%2): проверьте места и радиусы противовесов.</translation>
    </message>
    <message>
        <source>difference of its inertia from two masses; acts on roll moment and torque</source>
        <translation>отличие его инерции от двух масс; действует на опрокидывающий и крутящий моменты</translation>
    </message>
    <message>
        <source>Gas forces act inside the engine, outside only as torque; they have the half orders.</source>
        <translation>Силы газов действуют внутри двигателя, наружу — лишь крутящим моментом; половинные порядки — от них.</translation>
    </message>
    <message>
        <source>All cylinders have the same masses, crank radius and rod, except articulated rods.</source>
        <translation>У всех цилиндров одинаковые массы, радиус кривошипа и шатун — кроме прицепных шатунов.</translation>
    </message>
    <message>
        <source>The inertia of a master rod&apos;s big end beyond the mass at its knuckle pins is neglected.</source>
        <translation>Инерция нижней головки главного шатуна сверх массы у пальцев прицепных шатунов не учитывается.</translation>
    </message>
    <message>
        <source>must be less than %1 in magnitude (rod length minus crank radius); %2</source>
        <translation>по модулю должно быть меньше %1 (длина шатуна минус радиус кривошипа); %2</translation>
    </message>
    <message>
        <source>must be left out with articulated rods (cylinder %1): master and articulated rods differ in mass, so enter their shares in the masses</source>
        <translation>не указывается при прицепных шатунах (цилиндр %1): массы шатунов различны, введите их доли в массах</translation>
    </message>
    <message>
        <source>must leave the articulated rod longer than %1, the distance of its knuckle pin from the cylinder&apos;s axis</source>
        <translation>прицепной шатун должен остаться длиннее %1, расстояния пальца прицепа от оси цилиндра</translation>
    </message>
    <message>
        <source>must be given for one cylinder (%1) if the throws carry different numbers of rods</source>
        <translation>нужно задать для одного цилиндра (%1): на коленах этого вала разное число шатунов</translation>
    </message>
    <message>
        <source>must give both ends of the rod a mass of at least 0</source>
        <translation>массы обеих головок шатуна должны остаться неотрицательными</translation>
    </message>
    <message>
        <source>This crank cannot fire in the order %1 in two turns.</source>
        <translation>На этом валу порядок %1 за два оборота невозможен.</translation>
    </message>
    <message>
        <source>This crank cannot fire in the order %1 in one turn (two-stroke); the order of its dead centres is %2.</source>
        <translation>На этом валу порядок %1 за один оборот (двухтактный) невозможен; порядок его мёртвых точек %2.</translation>
    </message>
    <message>
        <source>must keep the articulated rod farther from locking: its exact orders are not accurate enough</source>
        <translation>прицепной шатун должен быть дальше от заклинивания: его точные порядки недостаточно точны</translation>
    </message>
    <message>
        <source>Maximum residual force: %1, order %2.</source>
        <translation>Максимальная остаточная сила: %1, порядок %2.</translation>
    </message>
    <message>
        <source>Maximum residual moment: %1, order %2.</source>
        <translation>Максимальный остаточный момент: %1, порядок %2.</translation>
    </message>
    <message>
        <source>Cylinders %1 share a crankpin but are computed as plain rods: &quot;Articulated rods&quot; above the table adds a second order of 5 to 12 % and uneven dead centres.</source>
        <translation>Цилиндры %1 на одной шейке считаются с обычными шатунами: отметка «Прицепные шатуны» над таблицей добавит второй порядок, 5–12 %, и неравномерность мёртвых точек.</translation>
    </message>
    <message>
        <source>1 cancels the forward half of the reciprocating first order; in a single cylinder this is a balance factor of 50 %.</source>
        <translation>1 гасит прямую половину первого порядка поступательных масс. Для одного цилиндра это коэффициент балансировки 50&#xa0;%.</translation>
    </message>
    <message>
        <source>Axial position</source>
        <translation>Положение вдоль вала</translation>
    </message>
    <message>
        <source>Bank angle</source>
        <translation>Угол ряда</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Дезаксаж</translation>
    </message>
    <message>
        <source>Articulated rod</source>
        <translation>Прицепной шатун</translation>
    </message>
    <message>
        <source>Knuckle radius</source>
        <translation>Радиус пальца прицепа</translation>
    </message>
    <message>
        <source>Knuckle angle</source>
        <translation>Угол пальца прицепа</translation>
    </message>
    <message>
        <source>Rod length</source>
        <translation>Длина шатуна</translation>
    </message>
    <message>
        <source>Master rod</source>
        <translation>Главный шатун</translation>
    </message>
    <message>
        <source>Knuckle mass</source>
        <translation>Масса у пальца прицепа</translation>
    </message>
    <message>
        <source>must be empty: this rod runs on the crankpin</source>
        <translation>должно быть пусто: этот шатун сидит на шатунной шейке</translation>
    </message>
    <message>
        <source>&amp;Share of forward order 1</source>
        <translation>&amp;Доля прямого 1-го порядка</translation>
    </message>
    <message>
        <source>forward part</source>
        <translation>прямая часть</translation>
    </message>
    <message>
        <source>backward part</source>
        <translation>обратная часть</translation>
    </message>
    <message>
        <source>the bank angle is missing</source>
        <translation>не задан угол развала</translation>
    </message>
    <message>
        <source>the bank offset needs the cylinder spacing</source>
        <translation>к смещению рядов нужен шаг цилиндров</translation>
    </message>
    <message>
        <source>must be a list of %1 angles</source>
        <translation>должно быть списком углов, всего %1</translation>
    </message>
    <message>
        <source>Equal crankpins</source>
        <translation>Равные шейки</translation>
    </message>
    <message>
        <source>Fewest moves</source>
        <translation>Меньше перестановок</translation>
    </message>
    <message>
        <source>Place the parts for</source>
        <translation>Цель подбора</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>без предела</translation>
    </message>
    <message>
        <source>Crankpins at</source>
        <translation>Углы шеек</translation>
    </message>
    <message>
        <source>as usual</source>
        <translation>обычные</translation>
    </message>
    <message>
        <source>Cylinder spacing</source>
        <translation>Шаг цилиндров</translation>
    </message>
    <message>
        <source>no couple</source>
        <translation>без момента</translation>
    </message>
    <message>
        <source>Bank offset</source>
        <translation>Смещение рядов</translation>
    </message>
    <message>
        <source>Crank radius</source>
        <translation>Радиус кривошипа</translation>
    </message>
    <message>
        <source>no force</source>
        <translation>без силы</translation>
    </message>
    <message>
        <source>enter %1 angles of the crankpins</source>
        <translation>введите углы колен, всего %1</translation>
    </message>
    <message>
        <source>The permitted range of the crankpins is missing: they are made as equal as possible.</source>
        <translation>Не задан допустимый размах шеек: они уравнены насколько возможно.</translation>
    </message>
    <message>
        <source>Shaking cannot be computed (%1): the crankpins are made as equal as possible.</source>
        <translation>Тряску вычислить нельзя (%1): шейки уравнены насколько возможно.</translation>
    </message>
    <message>
        <source>No combination gives a range of %1: the crankpins are made as equal as possible. Make the heavier parts lighter.</source>
        <translation>Никакая расстановка не даёт размаха %1: шейки уравнены насколько возможно. Облегчите более тяжёлые детали.</translation>
    </message>
    <message>
        <source>No combination found gives a range of %1: the crankpins are made as equal as possible. Make the heavier parts lighter.</source>
        <translation>Ни одна найденная расстановка не даёт размаха %1: шейки уравнены насколько возможно. Облегчите более тяжёлые детали.</translation>
    </message>
    <message>
        <source>is required with the bank offset</source>
        <translation>необходимо, если задано смещение рядов</translation>
    </message>
    <message>
        <source>Minimum shaking</source>
        <translation>Минимальная тряска</translation>
    </message>
    <message>
        <source>anywhere</source>
        <translation>куда угодно</translation>
    </message>
    <message>
        <source>within bank</source>
        <translation>в своём ряду</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>на месте</translation>
    </message>
    <message>
        <source>with its set</source>
        <translation>с комплектом</translation>
    </message>
    <message>
        <source>Matching of weighed parts: goal, and permitted moves.</source>
        <translation>Подбор взвешенных деталей: цель и допустимые перестановки.</translation>
    </message>
    <message>
        <source>Minimum range of the crankpins, fewest moves to the permitted range, or minimum first-order shaking at the ends of the crankshaft.</source>
        <translation>Минимальный размах шеек, минимум перестановок до допустимого размаха или минимальная тряска первого порядка на концах вала.</translation>
    </message>
    <message>
        <source>Piston sets may move</source>
        <translation>Поршни можно ставить</translation>
    </message>
    <message>
        <source>Piston with pin and rings: anywhere; within its bank (valve pockets, offset pin); or fixed (fitted to the bore).</source>
        <translation>Поршень с пальцем и кольцами: куда угодно; в своём ряду (выемки под клапаны, смещённый палец); или на месте (пригнан к цилиндру).</translation>
    </message>
    <message>
        <source>Pins may move</source>
        <translation>Пальцы можно ставить</translation>
    </message>
    <message>
        <source>With its set, or fixed.</source>
        <translation>С комплектом или на месте.</translation>
    </message>
    <message>
        <source>Rings may move</source>
        <translation>Кольца можно ставить</translation>
    </message>
    <message>
        <source>With its set, or fixed (gapped to the bore).</source>
        <translation>С комплектом или на месте (зазор подогнан к цилиндру).</translation>
    </message>
    <message>
        <source>Rods may move</source>
        <translation>Шатуны можно ставить</translation>
    </message>
    <message>
        <source>Rod with its shells: anywhere; within its bank (each faces its side of the crankpin); or fixed.</source>
        <translation>Шатун с вкладышами: куда угодно; в своём ряду (каждый обращён к своей щеке); или на месте.</translation>
    </message>
    <message>
        <source>Shells may move</source>
        <translation>Вкладыши можно ставить</translation>
    </message>
    <message>
        <source>With its set, or fixed (chosen for the journal).</source>
        <translation>С комплектом или на месте (подобраны к шейке).</translation>
    </message>
    <message>
        <source>Permitted crankpin range</source>
        <translation>Допустимый размах шеек</translation>
    </message>
    <message>
        <source>Heaviest minus lightest crankpin by bob weight, for the goal “Fewest moves”.</source>
        <translation>Самая тяжёлая шейка минус самая лёгкая по грузу, для цели «Меньше перестановок».</translation>
    </message>
    <message>
        <source>Angles of the throws from the front, positive from the second bank to the first.</source>
        <translation>Углы колен при взгляде спереди, положительные от второго ряда к первому.</translation>
    </message>
    <message>
        <source>usual for the engine, cross-plane V-8: 0; 90; 270; 180</source>
        <translation>обычные для двигателя, крестообразный вал V-8: 0; 90; 270; 180</translation>
    </message>
    <message>
        <source>Distance between neighbours of a bank along the crankshaft, for the couple.</source>
        <translation>Расстояние между соседними цилиндрами ряда вдоль вала, для момента.</translation>
    </message>
    <message>
        <source>Distance of the second bank behind the first (width of a big end). Enter the spacing too.</source>
        <translation>На сколько второй ряд смещён назад от первого (ширина нижней головки). Введите и шаг цилиндров.</translation>
    </message>
    <message>
        <source>Crank radius for forces in g·mm and N; without it they are masses at the crank radius.</source>
        <translation>Радиус кривошипа для сил в г·мм и Н; без него это массы на этом радиусе.</translation>
    </message>
    <message>
        <source>Best shaft angle</source>
        <translation>Наилучший угол вала</translation>
    </message>
    <message>
        <source>one search over all α, with the table prepared</source>
        <translation>один поиск по всем α, таблица подготовлена</translation>
    </message>
    <message>
        <source>scan</source>
        <translation>перебор</translation>
    </message>
    <message>
        <source>Brent&apos;s method</source>
        <translation>метод Брента</translation>
    </message>
    <message>
        <source>finds one of several minima, and on a kink its parabolas do not help</source>
        <translation>находит один из нескольких минимумов, а на изломе его параболы не помогают</translation>
    </message>
    <message>
        <source>one start</source>
        <translation>одно начало</translation>
    </message>
    <message>
        <source>from a scan of %1°</source>
        <translation>после перебора через %1°</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 шагов</translation>
    </message>
    <message>
        <source>cutting planes</source>
        <translation>отсекающие плоскости</translation>
    </message>
    <message>
        <source>exact: the bounds prove that no angle is better</source>
        <translation>точен: границы доказывают, что лучшего угла нет</translation>
    </message>
    <message>
        <source>amplitude of the shaft&apos;s moment, the paper&apos;s torque</source>
        <translation>амплитуда момента вала, момент из статьи</translation>
    </message>
    <message>
        <source>width of the combustion peak</source>
        <translation>ширина пика сгорания</translation>
    </message>
    <message>
        <source>rows of a table read by the spline</source>
        <translation>строк таблицы, читаемой сплайном</translation>
    </message>
    <message>
        <source>rows of an irregular table</source>
        <translation>строк неравномерной таблицы</translation>
    </message>
    <message>
        <source>24 steps</source>
        <translation>24 шага</translation>
    </message>
    <message>
        <source>144 steps</source>
        <translation>144 шага</translation>
    </message>
    <message>
        <source>Gauss-Legendre, 10 points a panel</source>
        <translation>Гаусс–Лежандр, 10 точек на участок</translation>
    </message>
    <message>
        <source>converges slowly over the kinks at the rows; a peak inside one panel is lost</source>
        <translation>медленно сходится на изломах у строк; пик внутри одного участка теряется</translation>
    </message>
    <message>
        <source>1 panel</source>
        <translation>1 участок</translation>
    </message>
    <message>
        <source>4 panels</source>
        <translation>4 участка</translation>
    </message>
    <message>
        <source>%1 panels</source>
        <translation>%1 участков</translation>
    </message>
    <message>
        <source>72 panels</source>
        <translation>72 участка</translation>
    </message>
    <message>
        <source>exact integral of the interpolant</source>
        <translation>точный интеграл интерполянта</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>участки</translation>
    </message>
    <message>
        <source>Cycle mean and RMS</source>
        <translation>Среднее за цикл и СКЗ</translation>
    </message>
    <message>
        <source>node mean, end counted twice</source>
        <translation>среднее по узлам, конец учтён дважды</translation>
    </message>
    <message>
        <source>never: 720° is 0° again, so a pure sine gets a mean of A sin α / nodes (17.2 N·m in the paper)</source>
        <translation>нигде: 720° — это снова 0°, и чистый синус получает среднее A sin α / число узлов (17,2 Н·м в статье)</translation>
    </message>
    <message>
        <source>trapezoid rule</source>
        <translation>формула трапеций</translation>
    </message>
    <message>
        <source>a peak narrower than the step is seen or missed by chance; the kinks at the rows leave order 2</source>
        <translation>пик уже шага попадает в узел или пропадает случайно; изломы на строках оставляют порядок 2</translation>
    </message>
    <message>
        <source>shaft angle α, the paper&apos;s engine</source>
        <translation>угол вала α, двигатель статьи</translation>
    </message>
    <message>
        <source>shaft angle α, no torque but the shaft&apos;s</source>
        <translation>угол вала α, кроме момента вала ничего</translation>
    </message>
    <message>
        <source>runs into the spring&apos;s free length, where the equation is singular</source>
        <translation>доходит до свободной длины пружины, где уравнение имеет особенность</translation>
    </message>
    <message>
        <source>Guide of the elastic hinge</source>
        <translation>Направляющая шарнира</translation>
    </message>
    <message>
        <source>radius ρ(φ) of the crank&apos;s guide over one turn</source>
        <translation>радиус ρ(φ) направляющей кривошипа за оборот</translation>
    </message>
    <message>
        <source>part of the guide&apos;s relief</source>
        <translation>доля перепада направляющей</translation>
    </message>
    <message>
        <source>ρ at one crank angle</source>
        <translation>ρ при одном угле кривошипа</translation>
    </message>
    <message>
        <source>closed form as printed</source>
        <translation>замкнутая форма, как напечатано</translation>
    </message>
    <message>
        <source>a difference of nearly equal squares: it loses the digits of a small relief or a small preload</source>
        <translation>разность почти равных квадратов: теряет знаки при малом перепаде или малом преднатяге</translation>
    </message>
    <message>
        <source>closed form</source>
        <translation>замкнутая форма</translation>
    </message>
    <message>
        <source>free of cancellation</source>
        <translation>без потери знаков</translation>
    </message>
    <message>
        <source>Runge-Kutta of order 4</source>
        <translation>Рунге–Кутта 4-го порядка</translation>
    </message>
    <message>
        <source>Dormand-Prince with step control</source>
        <translation>Дорман–Принс с управлением шагом</translation>
    </message>
    <message>
        <source>stiffness c of the spring</source>
        <translation>жёсткость c пружины</translation>
    </message>
    <message>
        <source>crank speed ω</source>
        <translation>угловая скорость кривошипа ω</translation>
    </message>
    <message>
        <source>there is no guide</source>
        <translation>направляющей нет</translation>
    </message>
    <message>
        <source>%1 steps a turn</source>
        <translation>%1 шагов на оборот</translation>
    </message>
    <message>
        <source>Motion with a hinge</source>
        <translation>Движение с шарниром</translation>
    </message>
    <message>
        <source>one turn of motion</source>
        <translation>один оборот движения</translation>
    </message>
    <message>
        <source>Runge-Kutta of order 4, fixed step</source>
        <translation>Рунге–Кутта 4-го порядка, постоянный шаг</translation>
    </message>
    <message>
        <source>start speed, part of the design speed</source>
        <translation>начальная скорость, доля расчётной</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>обороты</translation>
    </message>
    <message>
        <source>two-term closed form</source>
        <translation>замкнутая форма, два члена</translation>
    </message>
    <message>
        <source>leaves λ³/4 in order 2 and all of the higher orders: three digits at λ = 0.25</source>
        <translation>оставляет λ³/4 во 2-м порядке и все высшие порядки: три знака при λ = 0,25</translation>
    </message>
    <message>
        <source>discrete Fourier transform</source>
        <translation>дискретное преобразование Фурье</translation>
    </message>
    <message>
        <source>orders above half the points fold onto the low ones: with large λ or K a short transform is wrong</source>
        <translation>порядки выше половины числа точек накладываются на низшие: при больших λ или K короткое преобразование неверно</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 точек</translation>
    </message>
    <message>
        <source>32 points</source>
        <translation>32 точки</translation>
    </message>
    <message>
        <source>64 points</source>
        <translation>64 точки</translation>
    </message>
    <message>
        <source>2 terms</source>
        <translation>2 члена</translation>
    </message>
    <message>
        <source>4 terms</source>
        <translation>4 члена</translation>
    </message>
    <message>
        <source>%1 terms</source>
        <translation>%1 членов</translation>
    </message>
    <message>
        <source>Inertia orders</source>
        <translation>Порядки сил инерции</translation>
    </message>
    <message>
        <source>orders 0 to 12 of force and torque of one cylinder</source>
        <translation>порядки силы и момента одного цилиндра от 0 до 12</translation>
    </message>
    <message>
        <source>all the orders of one cylinder</source>
        <translation>все порядки одного цилиндра</translation>
    </message>
    <message>
        <source>gives no finite number</source>
        <translation>не даёт конечного числа</translation>
    </message>
    <message>
        <source>nowhere</source>
        <translation>нигде</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>везде</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>при %1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>от %1</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>до %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>от %1 до %2</translation>
    </message>
    <message>
        <source>exact extrema of the pieces</source>
        <translation>точные экстремумы участков</translation>
    </message>
    <message>
        <source>the range at one α, with the table prepared</source>
        <translation>размах при одном α, таблица подготовлена</translation>
    </message>
    <message>
        <source>series in λ</source>
        <translation>ряд по λ</translation>
    </message>
    <message>
        <source>the terms left out are of the order (λ(1 + K))^2n: three digits at λ = 0.5 with 4 terms, and no convergence at locking</source>
        <translation>отброшенные члены порядка (λ(1 + K))^2n: три знака при λ = 0,5 с 4 членами, а при заклинивании ряд не сходится</translation>
    </message>
    <message>
        <source>3 terms</source>
        <translation>3 члена</translation>
    </message>
    <message>
        <source>float</source>
        <translation>float</translation>
    </message>
    <message>
        <source>double</source>
        <translation>double</translation>
    </message>
    <message>
        <source>exact, sines kept</source>
        <translation>точная, синусы хранятся</translation>
    </message>
    <message>
        <source>Slider-crank kinematics</source>
        <translation>Кинематика КШМ</translation>
    </message>
    <message>
        <source>s, s′, s″ of the piston pin over one turn</source>
        <translation>s, s′, s″ поршневого пальца за оборот</translation>
    </message>
    <message>
        <source>s, s′ and s″ at one crank angle</source>
        <translation>s, s′ и s″ при одном угле кривошипа</translation>
    </message>
    <message>
        <source>reproduced</source>
        <translation>воспроизведено</translation>
    </message>
    <message>
        <source>artefact</source>
        <translation>артефакт</translation>
    </message>
    <message>
        <source>not derivable</source>
        <translation>не выводится</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>расходится</translation>
    </message>
    <message>
        <source>introduction</source>
        <translation>введение</translation>
    </message>
    <message>
        <source>Quoted from other papers.</source>
        <translation>Приведено по другим работам.</translation>
    </message>
    <message>
        <source>displacement of five-cylinder engines</source>
        <translation>рабочий объём пятицилиндровых двигателей</translation>
    </message>
    <message>
        <source>angle between the banks of VR engines</source>
        <translation>угол развала двигателей VR</translation>
    </message>
    <message>
        <source>parameters of the engine</source>
        <translation>параметры двигателя</translation>
    </message>
    <message>
        <source>offset e</source>
        <translation>дезаксаж e</translation>
    </message>
    <message>
        <source>relative offset K</source>
        <translation>относительный дезаксаж K</translation>
    </message>
    <message>
        <source>crank angle at top dead centre</source>
        <translation>угол кривошипа в верхней мёртвой точке</translation>
    </message>
    <message>
        <source>arcsin(λK / (1 + λ)).</source>
        <translation>arcsin(λK / (1 + λ)).</translation>
    </message>
    <message>
        <source>shift of the crankpins of bank 2</source>
        <translation>смещение шатунных шеек ряда 2</translation>
    </message>
    <message>
        <source>To 1′: the paper adds up angles rounded to minutes.</source>
        <translation>До 1′: статья складывает углы, округлённые до минут.</translation>
    </message>
    <message>
        <source>Fig. 2a</source>
        <translation>рис. 2а</translation>
    </message>
    <message>
        <source>angle from crankpin %1 to %2</source>
        <translation>угол от шейки %1 до %2</translation>
    </message>
    <message>
        <source>Fig. 2b</source>
        <translation>рис. 2б</translation>
    </message>
    <message>
        <source>coefficient of a cos φ</source>
        <translation>коэффициент при a cos φ</translation>
    </message>
    <message>
        <source>coefficient of l cos φ</source>
        <translation>коэффициент при l cos φ</translation>
    </message>
    <message>
        <source>coefficient of a sin φ</source>
        <translation>коэффициент при a sin φ</translation>
    </message>
    <message>
        <source>coefficient of l sin φ</source>
        <translation>коэффициент при l sin φ</translation>
    </message>
    <message>
        <source>coefficient of a cos 2φ</source>
        <translation>коэффициент при a cos 2φ</translation>
    </message>
    <message>
        <source>coefficient of l cos 2φ</source>
        <translation>коэффициент при l cos 2φ</translation>
    </message>
    <message>
        <source>coefficient of a sin 2φ</source>
        <translation>коэффициент при a sin 2φ</translation>
    </message>
    <message>
        <source>coefficient of l sin 2φ</source>
        <translation>коэффициент при l sin 2φ</translation>
    </message>
    <message>
        <source>To one unit of the last digit: the paper adds up sines of angles rounded to minutes. l counts from crankpin 4.</source>
        <translation>До единицы последнего знака: статья складывает синусы углов, округлённых до минут. l отсчитывается от шейки 4.</translation>
    </message>
    <message>
        <source>To 1′, from the two-term orders: the paper computes on with rounded coefficients.</source>
        <translation>До 1′, по двучленным порядкам: статья считает дальше с округлёнными коэффициентами.</translation>
    </message>
    <message>
        <source>Fig. 7a</source>
        <translation>рис. 7а</translation>
    </message>
    <message>
        <source>plane of the moment of the shaft at +ω</source>
        <translation>плоскость момента вала с +ω</translation>
    </message>
    <message>
        <source>from the x axis</source>
        <translation>от оси x</translation>
    </message>
    <message>
        <source>Fig. 7b</source>
        <translation>рис. 7б</translation>
    </message>
    <message>
        <source>plane of the moment of the shaft at −ω</source>
        <translation>плоскость момента вала с −ω</translation>
    </message>
    <message>
        <source>from the y axis</source>
        <translation>от оси y</translation>
    </message>
    <message>
        <source>Fig. 8a</source>
        <translation>рис. 8а</translation>
    </message>
    <message>
        <source>plane of the moment of the shaft at +2ω</source>
        <translation>плоскость момента вала с +2ω</translation>
    </message>
    <message>
        <source>Fig. 8b</source>
        <translation>рис. 8б</translation>
    </message>
    <message>
        <source>plane of the moment of the shaft at −2ω</source>
        <translation>плоскость момента вала с −2ω</translation>
    </message>
    <message>
        <source>Found from the crank with its shift γ_ш varied.</source>
        <translation>Найдено по валу с изменяемым смещением γ_ш.</translation>
    </message>
    <message>
        <source>coefficient of sin γ_ш</source>
        <translation>коэффициент при sin γ_ш</translation>
    </message>
    <message>
        <source>coefficient of sin²(γ_ш/2)</source>
        <translation>коэффициент при sin²(γ_ш/2)</translation>
    </message>
    <message>
        <source>constant part</source>
        <translation>постоянная часть</translation>
    </message>
    <message>
        <source>coefficient of cos γ_ш</source>
        <translation>коэффициент при cos γ_ш</translation>
    </message>
    <message>
        <source>To 1′: the paper computes with 21°40′.</source>
        <translation>До 1′: статья считает с 21°40′.</translation>
    </message>
    <message>
        <source>after ΣM_c</source>
        <translation>после ΣM_c</translation>
    </message>
    <message>
        <source>counterweight against the force</source>
        <translation>противовес от силы</translation>
    </message>
    <message>
        <source>lag behind crankpin 1</source>
        <translation>отставание от шейки 1</translation>
    </message>
    <message>
        <source>counterweight against the moment</source>
        <translation>противовес от момента</translation>
    </message>
    <message>
        <source>plane of ΣM_c against crankpin 1</source>
        <translation>плоскость ΣM_c относительно шейки 1</translation>
    </message>
    <message>
        <source>dynamic calculation</source>
        <translation>динамический расчёт</translation>
    </message>
    <message>
        <source>angular speed ω at %1 min⁻¹</source>
        <translation>угловая скорость ω при %1 мин⁻¹</translation>
    </message>
    <message>
        <source>π is rounded to 3.14.</source>
        <translation>π округлено до 3,14.</translation>
    </message>
    <message>
        <source>crank radius r</source>
        <translation>радиус кривошипа r</translation>
    </message>
    <message>
        <source>Half the stroke of 9.2 cm in the engine&apos;s type.</source>
        <translation>Половина хода 9,2 см из обозначения двигателя.</translation>
    </message>
    <message>
        <source>The sum of Table 1 with the heavier piston.</source>
        <translation>Сумма по табл. 1 с более тяжёлым поршнем.</translation>
    </message>
    <message>
        <source>counterweight m₁</source>
        <translation>противовес m₁</translation>
    </message>
    <message>
        <source>Equation (1).</source>
        <translation>Формула (1).</translation>
    </message>
    <message>
        <source>counterweight&apos;s force P₁</source>
        <translation>сила противовеса P₁</translation>
    </message>
    <message>
        <source>rated power</source>
        <translation>номинальная мощность</translation>
    </message>
    <message>
        <source>speed of Table 2</source>
        <translation>частота вращения табл. 2</translation>
    </message>
    <message>
        <source>last column</source>
        <translation>последний столбец</translation>
    </message>
    <message>
        <source>The mean of the 25 rows counts the end of the cycle twice; the cycle mean of a sine is 0 for every α.</source>
        <translation>Среднее 25 строк учитывает конец цикла дважды; среднее синуса за цикл равно 0 при любом α.</translation>
    </message>
    <message>
        <source>mean under the last column</source>
        <translation>среднее под последним столбцом</translation>
    </message>
    <message>
        <source>The mean of the 49 rows of Table 2, not of the 25 values above it; the end of the cycle is counted twice.</source>
        <translation>Среднее 49 строк табл. 2, а не 25 чисел над ним; конец цикла учтён дважды.</translation>
    </message>
    <message>
        <source>before Table %1</source>
        <translation>перед табл. %1</translation>
    </message>
    <message>
        <source>Only the 25 printed rows give the printed means; rows every 5° would give a sixth of them.</source>
        <translation>Напечатанные средние дают только 25 напечатанных строк; строки через 5° дали бы их шестую часть.</translation>
    </message>
    <message>
        <source>results</source>
        <translation>результаты</translation>
    </message>
    <message>
        <source>upper end of the α that lower the mean</source>
        <translation>верхняя граница α, снижающих среднее</translation>
    </message>
    <message>
        <source>abstract</source>
        <translation>аннотация</translation>
    </message>
    <message>
        <source>rational α</source>
        <translation>рациональный α</translation>
    </message>
    <message>
        <source>α below which the overall size shrinks</source>
        <translation>α, ниже которого габарит уменьшается</translation>
    </message>
    <message>
        <source>No sizes of the engine are printed.</source>
        <translation>Размеры двигателя не напечатаны.</translation>
    </message>
    <message>
        <source>conclusions</source>
        <translation>выводы</translation>
    </message>
    <message>
        <source>advised α</source>
        <translation>рекомендуемый α</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%1 л</translation>
    </message>
    <message>
        <source>%1 and %2 l</source>
        <translation>%1 и %2 л</translation>
    </message>
    <message>
        <source>r_p / r.</source>
        <translation>r_p / r.</translation>
    </message>
    <message>
        <source>2 r_p / r, eq. (11).</source>
        <translation>2 r_p / r, ф-ла (11).</translation>
    </message>
    <message>
        <source>slope d(Δm_yk)/d(Δm) (24)</source>
        <translation>наклон d(Δm_yk)/d(Δm) (24)</translation>
    </message>
    <message>
        <source>k_y.</source>
        <translation>k_y.</translation>
    </message>
    <message>
        <source>Equation (18) solved for Δm.</source>
        <translation>Формула (18), решённая относительно Δm.</translation>
    </message>
    <message>
        <source>Equation (22).</source>
        <translation>Формула (22).</translation>
    </message>
    <message>
        <source>excess that aluminium plugs compensate</source>
        <translation>избыток, компенсируемый алюминиевыми заглушками</translation>
    </message>
    <message>
        <source>Equation (19) from the printed constant part.</source>
        <translation>Формула (19) с напечатанной постоянной частью.</translation>
    </message>
    <message>
        <source>Δr / r, eq. (1).</source>
        <translation>Δr / r, ф-ла (1).</translation>
    </message>
    <message>
        <source>mass m_p of the plug</source>
        <translation>масса m_p заглушки</translation>
    </message>
    <message>
        <source>excess that an M27×1.5 aluminium plug compensates</source>
        <translation>избыток, компенсируемый алюминиевой заглушкой M27×1,5</translation>
    </message>
    <message>
        <source>experiments</source>
        <translation>эксперименты</translation>
    </message>
    <message>
        <source>residual unbalance in each correction plane</source>
        <translation>остаточный дисбаланс в каждой плоскости коррекции</translation>
    </message>
    <message>
        <source>text</source>
        <translation>текст</translation>
    </message>
    <message>
        <source>Table %1</source>
        <translation>табл. %1</translation>
    </message>
    <message>
        <source>Fig. %1</source>
        <translation>рис. %1</translation>
    </message>
    <message>
        <source>eq. (%1)</source>
        <translation>ф-ла (%1)</translation>
    </message>
    <message>
        <source>after eq. (%1)</source>
        <translation>после ф-лы (%1)</translation>
    </message>
    <message>
        <source>from</source>
        <translation>от</translation>
    </message>
    <message>
        <source>to</source>
        <translation>до</translation>
    </message>
    <message>
        <source>∮ M₁₂ dφ at ω = %1 s⁻¹</source>
        <translation>∮ M₁₂ dφ при ω = %1 с⁻¹</translation>
    </message>
    <message>
        <source>potential part</source>
        <translation>потенциальная часть</translation>
    </message>
    <message>
        <source>factor of M₁₂ (1 + λ cos φ / cos ψ)</source>
        <translation>множитель при M₁₂ (1 + λ cos φ / cos ψ)</translation>
    </message>
    <message>
        <source>From the mechanism&apos;s reduced inertia.</source>
        <translation>Из приведённого момента инерции механизма.</translation>
    </message>
    <message>
        <source>P₄ ℓ₂ = (P₃ + P₂/2) ℓ, at any speed.</source>
        <translation>P₄ ℓ₂ = (P₃ + P₂/2) ℓ при любой скорости.</translation>
    </message>
    <message>
        <source>P₄ at ℓ₂ = %1 m</source>
        <translation>P₄ при ℓ₂ = %1 м</translation>
    </message>
    <message>
        <source>Fig. 6a</source>
        <translation>рис. 6а</translation>
    </message>
    <message>
        <source>Fig. 6b</source>
        <translation>рис. 6б</translation>
    </message>
    <message>
        <source>The value rounded to three decimals, with a zero added.</source>
        <translation>Значение, округлённое до трёх знаков, с приписанным нулём.</translation>
    </message>
    <message>
        <source>Fig. 6c</source>
        <translation>рис. 6в</translation>
    </message>
    <message>
        <source>Quoted from another paper.</source>
        <translation>Приведено по другой работе.</translation>
    </message>
    <message>
        <source>all of these, from the table</source>
        <translation>все эти величины, из таблицы</translation>
    </message>
    <message>
        <source>energy, time by Gauss sums</source>
        <translation>энергия, время суммами Гаусса</translation>
    </message>
    <message>
        <source>crank angle and speed at nine times of the last turn, off the design speed</source>
        <translation>угол и скорость кривошипа в девять моментов последнего оборота при нерасчётной скорости</translation>
    </message>
    <message>
        <source>moment on the crank, 5 turns</source>
        <translation>момент на кривошипе, 5 оборотов</translation>
    </message>
    <message>
        <source>given</source>
        <translation>задано</translation>
    </message>
    <message>
        <source>angle between the banks γ</source>
        <translation>угол развала γ</translation>
    </message>
    <message>
        <source>bore in the engine&apos;s type</source>
        <translation>диаметр цилиндра в марке двигателя</translation>
    </message>
    <message>
        <source>stroke in the engine&apos;s type</source>
        <translation>ход поршня в марке двигателя</translation>
    </message>
    <message>
        <source>counterweight&apos;s radius ρ₁</source>
        <translation>радиус противовеса ρ₁</translation>
    </message>
    <message>
        <source>step of Table 3</source>
        <translation>шаг табл. 3</translation>
    </message>
    <message>
        <source>lower end of the α that lower the mean</source>
        <translation>нижняя граница α, снижающих среднее</translation>
    </message>
    <message>
        <source>α of Fig. %1</source>
        <translation>α рис. %1</translation>
    </message>
    <message>
        <source>cut of the mean moment, by our choice at α = %1°</source>
        <translation>снижение среднего момента, по нашему выбору при α = %1°</translation>
    </message>
    <message>
        <source>residual unbalance of the parts</source>
        <translation>остаточный дисбаланс деталей</translation>
    </message>
    <message>
        <source>The paper chooses it as an example.</source>
        <translation>Выбрано в статье для примера.</translation>
    </message>
    <message>
        <source>diameter of a larger thread</source>
        <translation>диаметр большей резьбы</translation>
    </message>
    <message>
        <source>pitch of a larger thread</source>
        <translation>шаг большей резьбы</translation>
    </message>
    <message>
        <source>guides 2: ρ₀</source>
        <translation>направляющие 2: ρ₀</translation>
    </message>
    <message>
        <source>place without first order</source>
        <translation>место без первого порядка</translation>
    </message>
    <message>
        <source>Best place of the shaft</source>
        <translation>Лучшее место вала</translation>
    </message>
    <message>
        <source>one search over all places, with the table prepared</source>
        <translation>один поиск по всем местам, таблица подготовлена</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>сетка</translation>
    </message>
    <message>
        <source>%1 a side</source>
        <translation>%1 на сторону</translation>
    </message>
    <message>
        <source>exact: the planes prove that no place is better</source>
        <translation>точно: плоскости доказывают, что лучшего места нет</translation>
    </message>
    <message>
        <source>mean of Mᵤₚₛ, its RMS about the mean, and the first order, which gives the RMS at every α</source>
        <translation>среднее Mᵤₚₛ, СКЗ около среднего и первый порядок, который даёт СКЗ при каждом α</translation>
    </message>
    <message>
        <source>Range of Mᵤₚₛ</source>
        <translation>Размах Mᵤₚₛ</translation>
    </message>
    <message>
        <source>piston mₚ</source>
        <translation>поршень mₚ</translation>
    </message>
    <message>
        <source>piston mₚ, in brackets</source>
        <translation>поршень mₚ, в скобках</translation>
    </message>
    <message>
        <source>piston pin mₚₚ</source>
        <translation>поршневой палец mₚₚ</translation>
    </message>
    <message>
        <source>piston rings mₚᵣ</source>
        <translation>поршневые кольца mₚᵣ</translation>
    </message>
    <message>
        <source>connecting rod mₛₕ</source>
        <translation>шатун mₛₕ</translation>
    </message>
    <message>
        <source>connecting rod mₛₕ, ±</source>
        <translation>шатун mₛₕ, ±</translation>
    </message>
    <message>
        <source>rod&apos;s part at the pin m₁</source>
        <translation>часть шатуна у пальца m₁</translation>
    </message>
    <message>
        <source>reciprocating mass mⱼ</source>
        <translation>возвратно-поступательная масса mⱼ</translation>
    </message>
    <message>
        <source>first-order inertia force Pⱼ₁ max</source>
        <translation>сила инерции первого порядка Pⱼ₁ max</translation>
    </message>
    <message>
        <source>mⱼ r ω² at the printed 376.8 rad/s.</source>
        <translation>mⱼ r ω² при напечатанных 376,8 рад/с.</translation>
    </message>
    <message>
        <source>mean of Mᵢ</source>
        <translation>среднее Mᵢ</translation>
    </message>
    <message>
        <source>mean of Mᵤₚ</source>
        <translation>среднее Mᵤₚ</translation>
    </message>
    <message>
        <source>mean Mₛₘ(α = %1°)</source>
        <translation>среднее Mₛₘ(α = %1°)</translation>
    </message>
    <message>
        <source>step of the means Mₛₘ in Table 3</source>
        <translation>шаг средних Mₛₘ в табл. 3</translation>
    </message>
    <message>
        <source>α at which Mₛ is a sine</source>
        <translation>α, при котором Mₛ — синусоида</translation>
    </message>
    <message>
        <source>α at which Mₛ is a cosine</source>
        <translation>α, при котором Mₛ — косинус</translation>
    </message>
    <message>
        <source>The mean of the nodes is positive up to there; the cycle mean of Mₛ is 0 for every α.</source>
        <translation>Среднее по узлам положительно до этого угла; среднее Mₛ за цикл равно 0 при любом α.</translation>
    </message>
    <message>
        <source>The mean of the nodes is positive from there; the cycle mean of Mₛ is 0 for every α.</source>
        <translation>Оттуда среднее по узлам положительно; среднее Mₛ за цикл равно 0 при любом α.</translation>
    </message>
    <message>
        <source>lower end of the α with Mₛₘ &lt; 0</source>
        <translation>нижняя граница α с Mₛₘ &lt; 0</translation>
    </message>
    <message>
        <source>upper end of the α with Mₛₘ &lt; 0</source>
        <translation>верхняя граница α с Mₛₘ &lt; 0</translation>
    </message>
    <message>
        <source>360 without its first digit: Mₛₘ of the nodes is negative from 180° to 360°.</source>
        <translation>360 без первой цифры: Mₛₘ по узлам отрицательно от 180° до 360°.</translation>
    </message>
    <message>
        <source>α from which Mₛₘ changes its sign</source>
        <translation>α, с которого Mₛₘ меняет знак</translation>
    </message>
    <message>
        <source>α from which Mₛₘ is negative</source>
        <translation>α, с которого Mₛₘ отрицательно</translation>
    </message>
    <message>
        <source>divisor of r² (P₁ + P₂) / g in Iₚᵣ(0)</source>
        <translation>делитель r² (P₁ + P₂) / g в Iₚᵣ(0)</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 проб</translation>
    </message>
    <message>
        <source>differences</source>
        <translation>разности</translation>
    </message>
    <message>
        <source>slopes at the nominal</source>
        <translation>наклоны при номинале</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>Монте-Карло</translation>
    </message>
    <message>
        <source>scrambled Sobol points</source>
        <translation>перемешанные точки Соболя</translation>
    </message>
    <message>
        <source>scatter of masses, lengths and speed, an amplitude</source>
        <translation>разброс масс, длин и частоты, амплитуда</translation>
    </message>
    <message>
        <source>in float the angle itself has seven digits; near locking the error grows as the rounding divided by 1 − λ(1 + K)</source>
        <translation>в float сам угол имеет семь знаков; вблизи заклинивания погрешность растёт как округление, делённое на 1 − λ(1 + K)</translation>
    </message>
    <message>
        <source>every angle of a scan where the slope turns, halved until it is found</source>
        <translation>каждый угол перебора, где наклон меняет знак, с делением пополам</translation>
    </message>
    <message>
        <source>Gauss-Legendre sums over the pieces, the spline by its bends</source>
        <translation>суммы Гаусса — Лежандра по участкам, сплайн — по вторым производным</translation>
    </message>
    <message>
        <source>speeds by the energy of the three bodies, times by Gauss-Legendre sums</source>
        <translation>скорости по энергии трёх тел, времена — суммами Гаусса — Лежандра</translation>
    </message>
    <message>
        <source>integrals of s″ over half turns by the double exponential rule</source>
        <translation>интегралы s″ по полуоборотам по двойному экспоненциальному правилу</translation>
    </message>
    <message>
        <source>extrema of every half degree by Newton&apos;s method</source>
        <translation>экстремумы на каждой половине градуса методом Ньютона</translation>
    </message>
    <message>
        <source>closed forms of mean and variance</source>
        <translation>среднее и дисперсия в замкнутом виде</translation>
    </message>
    <message>
        <source>the closure |crankpin − pin| = L, differentiated</source>
        <translation>замыкание |шатунная шейка − палец| = L и его производные</translation>
    </message>
    <message>
        <source>e / R, both as printed.</source>
        <translation>e / R, оба по статье.</translation>
    </message>
    <message>
        <source>Brent&apos;s method between the rows</source>
        <translation>метод Брента между строками</translation>
    </message>
    <message>
        <source>to %1 bits</source>
        <translation>до %1 бит</translation>
    </message>
    <message>
        <source>Computing the printed numbers.</source>
        <translation>Вычисляются напечатанные числа.</translation>
    </message>
    <message>
        <source>All %1 printed numbers are given, reproduced or explained.</source>
        <translation>Все напечатанные числа (%1) заданы, воспроизведены или объяснены.</translation>
    </message>
    <message>
        <source>%1 of %2 printed numbers differ without a reason.</source>
        <translation>Напечатанных чисел, отличающихся без объяснения: %1 из %2.</translation>
    </message>
    <message>
        <source>Measuring the methods on this machine.</source>
        <translation>Методы измеряются на этом компьютере.</translation>
    </message>
    <message>
        <source>The paper&apos;s conclusions use a mean, so it must be the mean of the cycle, not of some nodes: nine digits for any table. The pieces between the rows are integrated exactly; then each shaft angle needs three multiplications.</source>
        <translation>Выводы статьи опираются на среднее, поэтому оно должно быть средним за цикл, а не по узлам: девять знаков для любой таблицы. Участки между строками интегрируются точно; затем каждому углу вала нужны три умножения.</translation>
    </message>
    <message>
        <source>The optimum angle compares ranges, so nine digits. Nodes miss a peak between them; the extremum of a line plus a sine has a closed form, and only the few intervals that may contain it are solved.</source>
        <translation>Лучший угол сравнивает размахи, поэтому девять знаков. Узлы пропускают пик между ними; у экстремума суммы прямой и синуса есть формула, и решаются лишь те немногие интервалы, где он может быть.</translation>
    </message>
    <message>
        <source>The range is the maximum of many sinusoids, with kinks and several minima. Sinusoids that bound it from below exclude worse angles, so the optimum is proven, with fewer evaluations than a scan of 5°.</source>
        <translation>Размах — максимум многих синусоид, с изломами и несколькими минимумами. Синусоиды, ограничивающие его снизу, исключают худшие углы; поэтому оптимум доказан, и за меньшее число вычислений, чем при переборе через 5°.</translation>
    </message>
    <message>
        <source>Over the plane of places the range is convex: the maximum of linear functions minus their minimum. Planes below find its kinks, where other methods stop or jump, and prove that no place is better.</source>
        <translation>На плоскости мест размах выпуклый: максимум линейных функций минус их минимум. Плоскости под ним находят изломы, где другие методы останавливаются или прыгают, и доказывают, что лучшего места нет.</translation>
    </message>
    <message>
        <source>A guide acts by its relief, which may be a few micrometres on a radius of a hundred millimetres: seven digits of the relief. The closed form needs no step and no start. Without a difference of nearly equal squares it stays accurate until the spring releases all its energy.</source>
        <translation>Направляющая действует своим перепадом, а это могут быть микрометры на радиусе в сто миллиметров: семь знаков перепада. Формуле не нужны ни шаг, ни начальная точка. Без разности почти равных квадратов она точна, пока пружина не отдаст всю энергию.</translation>
    </message>
    <message>
        <source>Ripple is read to parts of a million after up to a thousand turns: an error of 1e-7 a turn. The energy gives the speed at every angle; only the time is integrated, without drift. Adaptive steps find the steep places of a turn, also with a moment on the crank, from rest and up to a reversal.</source>
        <translation>Неравномерность отсчитывают до миллионных долей после тысячи оборотов: погрешность 1e-7 на оборот. Скорость при каждом угле даёт энергия; интегрируется только время, без ухода. Адаптивные шаги находят крутые места оборота, также при моменте на кривошипе, из покоя и до обратного хода.</translation>
    </message>
    <message>
        <source>Reports print six digits, and balanced layouts must give zero as a difference of large forces: nine digits. The exact form needs one square root; a series of the same cost has three digits at λ = 0.5 and none near locking. The sines of the nodes are stored: every cylinder and turn needs them.</source>
        <translation>В отчётах шесть знаков, а уравновешенная схема должна давать нуль как разность больших сил: девять знаков. Точной форме нужен один квадратный корень; ряд той же стоимости даёт три знака при λ = 0,5 и ни одного вблизи заклинивания. Синусы узлов хранятся: они нужны каждому цилиндру и обороту.</translation>
    </message>
    <message>
        <source>In a balanced layout orders cancel and only rounding may remain: eleven digits. No fixed number of points suffices for every λ and K; the number follows from the known decay of the orders.</source>
        <translation>В уравновешенной схеме порядки гасят друг друга, остаться может лишь округление: одиннадцать знаков. Постоянного числа точек не хватает при всех λ и K; число следует из известного убывания порядков.</translation>
    </message>
    <message>
        <source>the α of the minimum range of Mᵤₚₛ</source>
        <translation>α минимального размаха Mᵤₚₛ</translation>
    </message>
    <message>
        <source>range minus minimum range, share of the maximum torque + A</source>
        <translation>размах минус минимальный размах, доля максимального момента плюс A</translation>
    </message>
    <message>
        <source>limited by its step, for any table</source>
        <translation>ограничен своим шагом, при любой таблице</translation>
    </message>
    <message>
        <source>difference of the two minima</source>
        <translation>разность двух минимумов</translation>
    </message>
    <message>
        <source>the place of the shaft with the minimum range of M_ups</source>
        <translation>место вала с минимальным размахом M_ups</translation>
    </message>
    <message>
        <source>ellipsoids around the place, cut by slopes</source>
        <translation>эллипсоиды вокруг искомого положения, отсекаемые по наклонам</translation>
    </message>
    <message>
        <source>the optimum of the RMS, not of the range</source>
        <translation>оптимум по СКЗ, а не по размаху</translation>
    </message>
    <message>
        <source>limited by its step, at a quadratic cost</source>
        <translation>ограничена шагом, при квадратичных затратах</translation>
    </message>
    <message>
        <source>share of the maximum torque of the table + A</source>
        <translation>доля максимального момента таблицы плюс A</translation>
    </message>
    <message>
        <source>exact for the interpolated table; the table does not show the engine between its rows</source>
        <translation>точен для интерполированной таблицы; что было между строками, таблица не показывает</translation>
    </message>
    <message>
        <source>the spring stores too little energy</source>
        <translation>пружина запасает слишком мало энергии</translation>
    </message>
    <message>
        <source>residual energy of the spring, from the energy of the three bodies</source>
        <translation>остаточная энергия пружины, по энергии трёх тел</translation>
    </message>
    <message>
        <source>half of the digits remain where the spring releases all its energy; beyond that no guide exists</source>
        <translation>половина знаков остаётся там, где пружина отдаёт всю энергию; дальше направляющей нет</translation>
    </message>
    <message>
        <source>loses its order where ρ approaches ℓ₀/2: the slope is infinite there</source>
        <translation>теряет порядок там, где ρ подходит к ℓ₀/2: наклон там бесконечен</translation>
    </message>
    <message>
        <source>its steps shrink to 0 where ρ approaches ℓ₀/2</source>
        <translation>шаги сжимаются до нуля там, где ρ подходит к ℓ₀/2</translation>
    </message>
    <message>
        <source>preload above the minimum, relative</source>
        <translation>преднатяг сверх минимального, относительно</translation>
    </message>
    <message>
        <source>stiffness c, preload 1.1 times the minimum</source>
        <translation>жёсткость c, преднатяг 1,1 от минимального</translation>
    </message>
    <message>
        <source>at this speed the time of a turn is below the range of numbers</source>
        <translation>при этой скорости время оборота вне пределов чисел</translation>
    </message>
    <message>
        <source>its steps shrink to 0</source>
        <translation>его шаги уменьшаются до нуля</translation>
    </message>
    <message>
        <source>rad, or share of the speed, per turn</source>
        <translation>рад или доля скорости на каждый оборот</translation>
    </message>
    <message>
        <source>its energy drifts: with 90 steps a turn it is wrong after thousands of turns, near λ = 1 at once</source>
        <translation>энергия уходит неуклонно: с 90 шагами на оборот он неверен через тысячи оборотов, а вблизи λ = 1 — сразу</translation>
    </message>
    <message>
        <source>the energy drifts by about the tolerance at every turn, without limit</source>
        <translation>энергия уходит примерно на допуск за каждый оборот, без предела</translation>
    </message>
    <message>
        <source>slower near a standstill; where the crank barely passes a dead point, rounding decides</source>
        <translation>медленнее вблизи остановки; где кривошип едва проходит мёртвую точку, решает округление</translation>
    </message>
    <message>
        <source>share of the maximum order, or of m R ω² and m R² ω²</source>
        <translation>доля максимального порядка либо m R ω² и m R² ω²</translation>
    </message>
    <message>
        <source>Fourier transform of sufficient length</source>
        <translation>преобразование Фурье достаточной длины</translation>
    </message>
    <message>
        <source>the number of points grows as 1/√(1 − λ(1 + K)); nearer to locking than 4·10⁻⁹ the module rejects the mechanism</source>
        <translation>число точек растёт как 1/√(1 − λ(1 + K)); ближе к заклиниванию, чем 4·10⁻⁹, модуль механизм не принимает</translation>
    </message>
    <message>
        <source>has an error beyond the range of numbers</source>
        <translation>ошибается сильнее, чем можно выразить числом</translation>
    </message>
    <message>
        <source>ΔMᵤₚₛ, maximum minus minimum moment over the cycle, at one α</source>
        <translation>ΔMᵤₚₛ, максимум момента за цикл минус минимум, при одном α</translation>
    </message>
    <message>
        <source>maximum and minimum node</source>
        <translation>максимальный и минимальный узел</translation>
    </message>
    <message>
        <source>cuts off an extremum between the nodes and misses a narrow peak</source>
        <translation>срезает экстремум между узлами и не видит узкого пика</translation>
    </message>
    <message>
        <source>finds only one of two extrema on long straight pieces</source>
        <translation>на длинных прямых участках находит лишь один из двух экстремумов</translation>
    </message>
    <message>
        <source>exact for the interpolated table</source>
        <translation>точен для интерполированной таблицы</translation>
    </message>
    <message>
        <source>In use: %1. No values here: %2.</source>
        <translation>Применяется: %1. Здесь чисел нет: %2.</translation>
    </message>
    <message>
        <source>In use: %1. Beyond the tolerance at this value.</source>
        <translation>Применяется: %1. При этом значении допуск не выдержан.</translation>
    </message>
    <message>
        <source>In use: %1. Within the tolerance; %2 of %3 settings within it are faster.</source>
        <translation>Применяется: %1. В допуске; из %3 настроек в допуске быстрее %2.</translation>
    </message>
    <message>
        <source>Uncertain inputs</source>
        <translation>Неточные исходные данные</translation>
    </message>
    <message>
        <source>mean and standard deviation of a result of uncertain inputs</source>
        <translation>среднее и стандартное отклонение результата при неточных исходных данных</translation>
    </message>
    <message>
        <source>larger error of both, share of the standard deviation, RMS over 16 seeds</source>
        <translation>большая из двух погрешностей, доля стандартного отклонения, среднеквадратично по 16 начальным числам</translation>
    </message>
    <message>
        <source>one study, without the cost of the result itself</source>
        <translation>одно исследование, без затрат на сам результат</translation>
    </message>
    <message>
        <source>does not include anything away from the nominal: a jump, a corner, a curve</source>
        <translation>не учитывает ничего вдали от номинала: скачка, излома, кривизны</translation>
    </message>
    <message>
        <source>converges always, but a digit needs a hundred times the samples</source>
        <translation>сходится всегда, но цифра требует стократного числа проб</translation>
    </message>
    <message>
        <source>a digit needs about ten times the samples; across a jump a little more</source>
        <translation>цифра стоит примерно десятикратного числа проб, через скачок — немного больше</translation>
    </message>
    <message>
        <source>difference of two minima, share of its scatter</source>
        <translation>разность двух минимумов, доля разброса</translation>
    </message>
    <message>
        <source>where a clearance limits, share of the input&apos;s scatter</source>
        <translation>где зазор ограничивает, доля разброса исходной величины</translation>
    </message>
    <message>
        <source>the mechanism locks: the crank cannot make a turn</source>
        <translation>механизм заклинивает: кривошип не делает оборота</translation>
    </message>
    <message>
        <source>share of the maximum |s|, |s′|, |s″| of the turn</source>
        <translation>доля максимальных |s|, |s′|, |s″| за оборот</translation>
    </message>
    <message>
        <source>near locking the error grows as the rounding divided by 1 − λ(1 + K): nine digits remain at 1 − λ(1 + K) = 10⁻⁶</source>
        <translation>вблизи заклинивания погрешность растёт как округление, делённое на 1 − λ(1 + K): при 1 − λ(1 + K) = 10⁻⁶ остаётся девять знаков</translation>
    </message>
    <message>
        <source>Stated by the paper; the program&apos;s input is 12.51 mm, which gives the printed K = 0.278.</source>
        <translation>Задано в статье; в программе задано 12,51 мм, тогда K равно напечатанному 0,278.</translation>
    </message>
    <message>
        <source>To 1′, from the exact top dead centre. Correct is γ + 2 φ; the printed γ + φ would give 18°20′.</source>
        <translation>До 1′, по точной верхней мёртвой точке. Верно γ + 2 φ; напечатанное γ + φ дало бы 18°20′.</translation>
    </message>
    <message>
        <source>Misprint of the sign: only a plus gives the paper&apos;s angle 75°43′.</source>
        <translation>Опечатка в знаке: только плюс даёт угол статьи 75°43′.</translation>
    </message>
    <message>
        <source>Stated by the paper; not used in any computation.</source>
        <translation>Задано в статье; ни в одном вычислении не используется.</translation>
    </message>
    <message>
        <source>Friction losses are not printed; our value is the indicated power of Table 2 at the printed speed.</source>
        <translation>Потери на трение не напечатаны; наше число — индикаторная мощность по табл. 2 при напечатанной скорости.</translation>
    </message>
    <message>
        <source>The program of Table 2 is not published; our value is the speed at which its inertia torque matches the masses of Table 1.</source>
        <translation>Программа для табл. 2 не опубликована; наше число — скорость, при которой инерционный момент в ней отвечает массам табл. 1.</translation>
    </message>
    <message>
        <source>Mᵤₚ = −Mᵢ, the program&apos;s input.</source>
        <translation>Mᵤₚ = −Mᵢ, исходная величина программы.</translation>
    </message>
    <message>
        <source>The mean of the 49 rows counts the end of the cycle, 720° = 0°, twice; our value is the cycle integral.</source>
        <translation>Среднее 49 строк учитывает конец цикла, 720° = 0°, дважды; наше число — интеграл за цикл.</translation>
    </message>
    <message>
        <source>To 0.01 N·m: l is not printed. Our value follows from the largest entry, rounded to 0.01 mm; equal printed entries differ by 0.01.</source>
        <translation>До 0,01 Н·м: l не напечатано. Наше число следует из наибольшего значения, округлено до 0,01 мм; равные числа в печати расходятся на 0,01.</translation>
    </message>
    <message>
        <source>The column is headed Mᵤₚ but contains Mₛ of α = 330°.</source>
        <translation>Столбец озаглавлен Mᵤₚ, но содержит Mₛ при α = 330°.</translation>
    </message>
    <message>
        <source>There Mₛ is P₁ l sin φ.</source>
        <translation>Там Mₛ равно P₁ l sin φ.</translation>
    </message>
    <message>
        <source>At 180° the mean of the nodes is 0 too, but Mₛ is a sine there; Mₛ is a cosine at 90°.</source>
        <translation>При 180° среднее по узлам тоже 0, но там Mₛ — синус; косинус она при 90°.</translation>
    </message>
    <message>
        <source>The nodes agree; the cycle mean of Mₛ is 0 for every α.</source>
        <translation>Узлы дают то же; среднее Mₛ за цикл равно 0 при любом α.</translation>
    </message>
    <message>
        <source>The paper names no α. The mean of the 49 rows (end counted twice) falls by 12 % at α from %1 to %2° and by 16 % from %3 to %4°. We use 30° (start of the paper&apos;s range) and 45° (Fig. 2); no shaft changes the cycle mean.</source>
        <translation>Статья не называет α. Среднее 49 строк (конец учтён дважды) падает на 12&#xa0;% при α от %1 до %2° и на 16&#xa0;% от %3 до %4°. Взяты 30° (начало диапазона статьи) и 45° (рис. 2); среднее за цикл вал не меняет.</translation>
    </message>
    <message>
        <source>α of the maximum ΔMᵤₚₛ</source>
        <translation>α максимального ΔMᵤₚₛ</translation>
    </message>
    <message>
        <source>Maximum over all α.</source>
        <translation>Максимум по всем α.</translation>
    </message>
    <message>
        <source>maximum ΔMᵤₚₛ</source>
        <translation>максимум ΔMᵤₚₛ</translation>
    </message>
    <message>
        <source>From a torque table of 5° that is not printed; our value uses the 15° table.</source>
        <translation>Взято из таблицы моментов через 5°, которая не напечатана; наше — по таблице через 15°.</translation>
    </message>
    <message>
        <source>No criterion is printed; our ends enclose the α with a smaller range than without a shaft.</source>
        <translation>Критерий не напечатан; наши границы охватывают α, где размах меньше, чем без вала.</translation>
    </message>
    <message>
        <source>maximum α advised</source>
        <translation>максимальный рекомендуемый α</translation>
    </message>
    <message>
        <source>No criterion is printed; our value is where the range becomes as large as without a shaft.</source>
        <translation>Критерий не напечатан; наше число — где размах становится таким же, как без вала.</translation>
    </message>
    <message>
        <source>Stated by the paper; not part of any of its equations.</source>
        <translation>Задано в статье; ни в одну её формулу не входит.</translation>
    </message>
    <message>
        <source>Stated by the paper, defined in another paper. Our value is the program&apos;s input.</source>
        <translation>Задано в статье, определено в другой. Наше число задано в программе.</translation>
    </message>
    <message>
        <source>m_pн with the ratio of aluminium to steel of the present plugs of the 6 and 7 l engines.</source>
        <translation>m_pн с отношением алюминия к стали по существующим заглушкам двигателей 6 и 7 л.</translation>
    </message>
    <message>
        <source>From k_y and k_yн as printed in Table 2; unrounded values change it by up to 0.003 g.</source>
        <translation>По k_y и k_yн, как они напечатаны в табл. 2; неокруглённые сдвигают его не более чем на 0,003 г.</translation>
    </message>
    <message>
        <source>From k_y and the constant part as printed; unrounded values change it by up to 0.003 g.</source>
        <translation>По k_y и постоянной части, как они напечатаны в таблицах; неокруглённые сдвигают его не более чем на 0,003 г.</translation>
    </message>
    <message>
        <source>The paper prints no m_p of this engine: it follows from this number.</source>
        <translation>В статье нет m_p этого двигателя: она найдена из этого числа.</translation>
    </message>
    <message>
        <source>excess compensated by the present steel plugs</source>
        <translation>избыток, компенсируемый существующими стальными заглушками</translation>
    </message>
    <message>
        <source>corresponding lightening of a steel plug</source>
        <translation>нужное для этого облегчение стальной заглушки</translation>
    </message>
    <message>
        <source>Equation (22) inverted: it was computed from this value.</source>
        <translation>Обращённая формула (22): по ней вычислено из этого числа.</translation>
    </message>
    <message>
        <source>equivalent lightening of a steel plug</source>
        <translation>равносильное этому облегчение стальной заглушки</translation>
    </message>
    <message>
        <source>maximum Δk</source>
        <translation>максимум Δk</translation>
    </message>
    <message>
        <source>maximum shift Δr</source>
        <translation>максимальное смещение Δr</translation>
    </message>
    <message>
        <source>The maximum Δk were computed from this value.</source>
        <translation>Из него вычислены наибольшие Δk.</translation>
    </message>
    <message>
        <source>The machined shapes are not printed.</source>
        <translation>Обработанные формы не напечатаны.</translation>
    </message>
    <message>
        <source>The drawing lacks dimensions; our value is a steel cup of the printed thread and height with a bore of 25 × 8 mm.</source>
        <translation>На чертеже не все размеры; наше число — стальной стакан с напечатанными резьбой и высотой и расточкой 25 × 8 мм.</translation>
    </message>
    <message>
        <source>Mass and radius of such a plug are not printed.</source>
        <translation>Масса и радиус такой заглушки не напечатаны.</translation>
    </message>
    <message>
        <source>A chosen limit, not computed.</source>
        <translation>Заданный предел, он не вычислялся.</translation>
    </message>
    <message>
        <source>Stated by the paper, with a drawing that lacks dimensions.</source>
        <translation>Задано в статье, у чертежа без полных размеров.</translation>
    </message>
    <message>
        <source>Stated by the paper; our value is the program&apos;s input.</source>
        <translation>Задано в статье; наше число задано в программе.</translation>
    </message>
    <message>
        <source>misprint</source>
        <translation>опечатка</translation>
    </message>
    <message>
        <source>With the paper&apos;s series for cos ψ; the inertia part is odd in φ and cancels at every speed.</source>
        <translation>С рядом статьи для cos ψ; инерционная часть нечётна по φ и выпадает при любой скорости.</translation>
    </message>
    <message>
        <source>To rounding, 1e-9 of the integral of its magnitude.</source>
        <translation>До округления, 10⁻⁹ интеграла модуля.</translation>
    </message>
    <message>
        <source>To rounding, with M₁₂ correctly outside the factor 0.5 of (8).</source>
        <translation>До округления, с M₁₂ вне множителя 0,5 в (8), как верно.</translation>
    </message>
    <message>
        <source>To rounding, with the counterweight of (10).</source>
        <translation>До округления, с противовесом по (10).</translation>
    </message>
    <message>
        <source>To rounding, with M₁₂* correctly outside the factor 0.5 of (11).</source>
        <translation>До округления, с M₁₂* вне множителя 0,5 в (11), как верно.</translation>
    </message>
    <message>
        <source>The bracket of 0.5 closes after M₁₂ instead of before it; the moment balance about the crank axis gives our value.</source>
        <translation>Скобка множителя 0,5 закрыта после M₁₂, а не перед ней; наше число даёт равновесие моментов относительно оси кривошипа.</translation>
    </message>
    <message>
        <source>ρ₀ of guides 1, ℓ₀/2: maximum with a guide</source>
        <translation>ρ₀ направляющих 1, ℓ₀/2: максимум, при котором направляющая есть</translation>
    </message>
    <message>
        <source>To 0.01 mm, and only with the sign of (1), by which spring and mechanism absorb energy together. For constant ω the spring must release it.</source>
        <translation>До 0,01 мм и лишь со знаком (1), по которому пружина и механизм поглощают энергию вместе. Для постоянного ω пружина должна её отдавать.</translation>
    </message>
    <message>
        <source>flywheel&apos;s share of an engine&apos;s inertia</source>
        <translation>доля маховика в моменте инерции двигателя</translation>
    </message>
    <message>
        <source>Uncertain inputs are known to a few digits, so a hundredth of the standard deviation suffices. Slopes give that for a few samples, but fail unnoticed where an optimum jumps or a clearance limits. Scrambled Sobol points give it everywhere with the fewest samples; other seeds show their error.</source>
        <translation>Неточные исходные данные известны до нескольких цифр, поэтому довольно сотой доли стандартного отклонения. Наклоны дают это за несколько проб, но незаметно неверны там, где оптимум скачет или зазор ограничивает. Перемешанные точки Соболя дают это везде при наименьшем числе проб; погрешность показывают другие начальные числа.</translation>
    </message>
    <message>
        <source>Open a case to see how certain its results are.</source>
        <translation>Откройте задачу, чтобы увидеть, насколько надёжны её результаты.</translation>
    </message>
    <message>
        <source>Solving the case for each change.</source>
        <translation>Задача решается для каждого изменения.</translation>
    </message>
    <message>
        <source>%1: %2. Maximum contribution: %3, %4.</source>
        <translation>%1: %2. Наибольший вклад: %3, %4.</translation>
    </message>
    <message>
        <source>distance from locking, 1 − λ</source>
        <translation>расстояние до заклинивания, 1 − λ</translation>
    </message>
    <message>
        <source>distance from locking by the offset, 1 − λ(1 + K), λ = 0.265</source>
        <translation>расстояние до заклинивания из-за дезаксажа, 1 − λ(1 + K), λ = 0,265</translation>
    </message>
    <message>
        <source>The open case is incomplete: no results.</source>
        <translation>Открытая задача не заполнена: результатов нет.</translation>
    </message>
    <message>
        <source>Balance shaft</source>
        <translation>Балансирный вал</translation>
    </message>
    <message>
        <source>Position the balance shaft of a single-cylinder engine</source>
        <translation>Положение балансирного вала одноцилиндрового двигателя</translation>
    </message>
    <message>
        <source>Elastic hinges</source>
        <translation>Упругие шарниры</translation>
    </message>
    <message>
        <source>Spring guides for constant crank speed</source>
        <translation>Пружинные направляющие для постоянной угловой скорости кривошипа</translation>
    </message>
    <message>
        <source>Workshop</source>
        <translation>Мастерская</translation>
    </message>
    <message>
        <source>From the scale to the drilled crankshaft, plugs of a V-8 included</source>
        <translation>От весов до просверленного коленчатого вала, с заглушками V-8</translation>
    </message>
    <message>
        <source>Inertia moments</source>
        <translation>Моменты сил инерции</translation>
    </message>
    <message>
        <source>Forces and moments of VR5 and any other cylinder layout</source>
        <translation>Силы и моменты VR5 и любой другой компоновки</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Линейный</translation>
    </message>
    <message>
        <source>Sobol points</source>
        <translation>Точки Соболя</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Сетка</translation>
    </message>
    <message>
        <source>must be a JSON pointer, such as /crank_radius_mm</source>
        <translation>должно быть указателем JSON, например /crank_radius_mm</translation>
    </message>
    <message>
        <source>must be a grid like the others; otherwise none may be a grid</source>
        <translation>должно быть сеткой, как и остальные; иначе сеток быть не должно</translation>
    </message>
    <message>
        <source>must make at most %1 points</source>
        <translation>должно давать не больше %1 точек</translation>
    </message>
    <message>
        <source>%1 has no linear answer: a derivative does not exist at the inputs&apos; means.</source>
        <translation>Для %1 линейного ответа нет: при средних значениях входных данных нет производной.</translation>
    </message>
    <message>
        <source>is a part of another case than %1</source>
        <translation>часть другой задачи, чем %1</translation>
    </message>
    <message>
        <source>is one of %1 parts, but %2 is one of %3</source>
        <translation>одна из %1 частей, а %2 — одна из %3</translation>
    </message>
    <message>
        <source>is the same part as %1: %2</source>
        <translation>та же часть, что и %1: %2</translation>
    </message>
    <message>
        <source>%1 of %2 parts are missing; run them again: --shard %3</source>
        <translation>не хватает %1 из %2 частей; запустите их ещё раз: --shard %3</translation>
    </message>
    <message>
        <source>The samples are too few for the sensitivities of %1: standard errors up to %2.</source>
        <translation>Для чувствительностей %1 проб мало: стандартные ошибки до %2.</translation>
    </message>
    <message>
        <source>must be &quot;linear&quot; or &quot;sobol&quot;: second-order studies are no longer supported</source>
        <translation>должно быть «linear» или «sobol»: исследования второго порядка больше не поддерживаются</translation>
    </message>
    <message>
        <source>must be &quot;sobol&quot; or &quot;monte-carlo&quot;: Latin hypercubes are no longer supported</source>
        <translation>должно быть «sobol» или «monte-carlo»: латинские гиперкубы больше не поддерживаются</translation>
    </message>
    <message>
        <source>%1 does not scatter and has no derivative: its tolerance is below the rounding of its value.</source>
        <translation>%1 не меняется и не имеет производной: допуск меньше ошибки округления значения.</translation>
    </message>
    <message>
        <source>must be %1; run the parts of other versions again</source>
        <translation>должно быть %1; части других версий запустите снова</translation>
    </message>
    <message>
        <source>must point to a number of the input</source>
        <translation>должно указывать на число во входных данных</translation>
    </message>
    <message>
        <source>must scatter less: its moments exceed the range of numbers</source>
        <translation>должно рассеиваться меньше: его моменты вне пределов чисел</translation>
    </message>
    <message>
        <source>must point to a number of the result</source>
        <translation>должно указывать на число в результате</translation>
    </message>
    <message>
        <source>must be nearer to from: their difference exceeds the range of numbers</source>
        <translation>должно быть ближе к from: их разность вне пределов чисел</translation>
    </message>
    <message>
        <source>must have one of: plus_minus, plus_minus_percent, normal_sd, from with to, values</source>
        <translation>должно содержать одно из: plus_minus, plus_minus_percent, normal_sd, from с to, values</translation>
    </message>
    <message>
        <source>must have from 1 to %1 pointers</source>
        <translation>должно содержать от 1 до %1 указателей</translation>
    </message>
    <message>
        <source>must be at least %1; across 0° add the period of the angle</source>
        <translation>должно быть не меньше %1; через 0° добавьте период угла</translation>
    </message>
    <message>
        <source>must be &quot;grid&quot; with listed values</source>
        <translation>должно быть &quot;grid&quot;, если перечислены значения</translation>
    </message>
    <message>
        <source>must not be &quot;grid&quot; without a grid</source>
        <translation>не может быть &quot;grid&quot;, если сетка не задана</translation>
    </message>
    <message>
        <source>%1 of %2 trial samples cannot be solved; the linear answer does not show that.</source>
        <translation>%1 из %2 опробованных проб решить нельзя; линейный ответ этого не показывает.</translation>
    </message>
    <message>
        <source>A standard deviation needs two solved samples.</source>
        <translation>Для стандартного отклонения нужны две решённые пробы.</translation>
    </message>
    <message>
        <source>is not the checksum of the part: the part was changed; run it again</source>
        <translation>не контрольная сумма этой части: часть изменена; запустите её снова</translation>
    </message>
    <message>
        <source>was computed by another program or machine than %1: the first numbers differ</source>
        <translation>посчитано другой программой или машиной, чем %1: исходные числа иные</translation>
    </message>
    <message>
        <source>was not written by this program</source>
        <translation>записано не этой программой</translation>
    </message>
    <message>
        <source>The linear answer fails for %1: the samples deviate from it by %2 (RMS), standard deviation %3.</source>
        <translation>Линейный ответ для %1 неверен: пробы отклоняются от него на %2 (СКЗ), стандартное отклонение %3.</translation>
    </message>
    <message>
        <source>mⱼ and m_R nominal reciprocating and rotating mass, mₘ oil, k_m its coefficient</source>
        <translation>mⱼ и m_R — номинальные поступательная и вращающаяся массы, mₘ — масло, k_m — его коэффициент</translation>
    </message>
    <message>
        <source>Bob weight, steel plugs</source>
        <translation>Балансировочный груз, стальные заглушки</translation>
    </message>
    <message>
        <source>Bob weight, aluminium plugs</source>
        <translation>Балансировочный груз, алюминиевые заглушки</translation>
    </message>
    <message>
        <source>Coefficients</source>
        <translation>Коэффициенты</translation>
    </message>
    <message>
        <source>Excess on the crankpin axis</source>
        <translation>Лишняя масса на оси шатунной шейки</translation>
    </message>
    <message>
        <source>Δmₚ piston, Δm_b big end of the rod, in repair Δm_rp repair piston with rings and Δm_sh repair shells; kᵣ coefficient of the rod</source>
        <translation>Δmₚ — поршень, Δm_b — нижняя головка шатуна, в ремонте Δm_rp — ремонтный поршень с кольцами и Δm_sh — ремонтные вкладыши; kᵣ — коэффициент шатуна</translation>
    </message>
    <message>
        <source>Lightening of each plug</source>
        <translation>Облегчение каждой заглушки</translation>
    </message>
    <message>
        <source>Aluminium in place of steel plugs</source>
        <translation>Алюминиевые заглушки вместо стальных</translation>
    </message>
    <message>
        <source>constant part; mₛ and mₐ mass of a plug of steel and of aluminium</source>
        <translation>постоянная часть; mₛ и mₐ — масса стальной и алюминиевой заглушки</translation>
    </message>
    <message>
        <source>constant parts with plugs of steel and of aluminium; mₛₙ mass of a new steel plug</source>
        <translation>постоянные части со стальными и с алюминиевыми заглушками; mₛₙ — масса новой стальной заглушки</translation>
    </message>
    <message>
        <source>Compensated by an option</source>
        <translation>Компенсируется вариантом</translation>
    </message>
    <message>
        <source>Cᵢ its constant part, Δmᵢ lightening of each plug, up to the limit of its wall</source>
        <translation>Cᵢ — его постоянная часть, Δmᵢ — облегчение каждой заглушки, до предела по стенке</translation>
    </message>
    <message>
        <source>the engine has no such plug</source>
        <translation>в этом двигателе нет такой заглушки</translation>
    </message>
    <message>
        <source>Excess on a crankpin Δmᵤ</source>
        <translation>Избыток на шатунной шейке Δmᵤ</translation>
    </message>
    <message>
        <source>Excess mass of the parts on the crankpin axis.</source>
        <translation>Избыточная масса деталей на оси шатунной шейки.</translation>
    </message>
    <message>
        <source>Unbalance of a crankpin</source>
        <translation>Дисбаланс шатунной шейки</translation>
    </message>
    <message>
        <source>Coefficient kₚ</source>
        <translation>Коэффициент kₚ</translation>
    </message>
    <message>
        <source>Coefficient kᵤ</source>
        <translation>Коэффициент kᵤ</translation>
    </message>
    <message>
        <source>Coefficient kᵤₙ</source>
        <translation>Коэффициент kᵤₙ</translation>
    </message>
    <message>
        <source>Slope angle</source>
        <translation>Угол наклона</translation>
    </message>
    <message>
        <source>Mass changes</source>
        <translation>Изменения масс</translation>
    </message>
    <message>
        <source>Options</source>
        <translation>Варианты</translation>
    </message>
    <message>
        <source>Plug</source>
        <translation>Заглушка</translation>
    </message>
    <message>
        <source>Balancing machine</source>
        <translation>Балансировочный станок</translation>
    </message>
    <message>
        <source>Fixed part</source>
        <translation>Постоянная часть</translation>
    </message>
    <message>
        <source>Compensated without machining.</source>
        <translation>Компенсируется без обработки.</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Коэффициент</translation>
    </message>
    <message>
        <source>Compensated by a gram off each plug.</source>
        <translation>Компенсируется при снятии грамма с каждой заглушки.</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Предел</translation>
    </message>
    <message>
        <source>Required off each plug</source>
        <translation>Требуется снять с заглушки</translation>
    </message>
    <message>
        <source>Off each plug, paper&apos;s method</source>
        <translation>Снять с заглушки по методу статьи</translation>
    </message>
    <message>
        <source>Take off each plug</source>
        <translation>Снять с заглушки</translation>
    </message>
    <message>
        <source>With the shift of the plug&apos;s centre of mass, where the shift matters.</source>
        <translation>С учётом смещения центра масс заглушки, где оно существенно.</translation>
    </message>
    <message>
        <source>Remains</source>
        <translation>Остаток</translation>
    </message>
    <message>
        <source>Residual unbalance</source>
        <translation>Остаточный дисбаланс</translation>
    </message>
    <message>
        <source>Bob weight, plugs in</source>
        <translation>Балансировочный груз, заглушки на месте</translation>
    </message>
    <message>
        <source>Bob weight, nominal</source>
        <translation>Балансировочный груз, номинал</translation>
    </message>
    <message>
        <source>Mass of a plug</source>
        <translation>Масса заглушки</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Смещение</translation>
    </message>
    <message>
        <source>Coefficient</source>
        <translation>Коэффициент</translation>
    </message>
    <message>
        <source>Effect of the shift</source>
        <translation>Влияние смещения</translation>
    </message>
    <message>
        <source>Beyond tolerance</source>
        <translation>Вне допуска</translation>
    </message>
    <message>
        <source>Corrected depth</source>
        <translation>Исправленная глубина</translation>
    </message>
    <message>
        <source>Boring</source>
        <translation>Расточка</translation>
    </message>
    <message>
        <source>Possible</source>
        <translation>Возможна</translation>
    </message>
    <message>
        <source>Deeper by</source>
        <translation>Глубже на</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Стенка</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Дно</translation>
    </message>
    <message>
        <source>Maximum by the walls</source>
        <translation>Предел по стенкам</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Номинал</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>До</translation>
    </message>
    <message>
        <source>Sum</source>
        <translation>Сумма</translation>
    </message>
    <message>
        <source>Crankpins</source>
        <translation>Шатунные шейки</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>Сталь</translation>
    </message>
    <message>
        <source>Aluminium</source>
        <translation>Алюминий</translation>
    </message>
    <message>
        <source>Mass by the sizes</source>
        <translation>Масса по размерам</translation>
    </message>
    <message>
        <source>Mass as entered</source>
        <translation>Введённая масса</translation>
    </message>
    <message>
        <source>Masses agree</source>
        <translation>Массы согласуются</translation>
    </message>
    <message>
        <source>Front plane</source>
        <translation>Передняя плоскость</translation>
    </message>
    <message>
        <source>Rear plane</source>
        <translation>Задняя плоскость</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Показание</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Годен</translation>
    </message>
    <message>
        <source>Steel plug</source>
        <translation>Стальная заглушка</translation>
    </message>
    <message>
        <source>Aluminium plug</source>
        <translation>Алюминиевая заглушка</translation>
    </message>
    <message>
        <source>%1: %2 entered, but a solid plug of these dimensions weighs %3. Enter its bore or weigh the plug.</source>
        <translation>%1: введено %2, но сплошная заглушка этих размеров весит %3. Введите расточку или взвесьте заглушку.</translation>
    </message>
    <message>
        <source>%1: %2 entered, but a plug of these dimensions weighs %3. Weigh the plug.</source>
        <translation>%1: введено %2, но заглушка этих размеров весит %3. Взвесьте заглушку.</translation>
    </message>
    <message>
        <source>r crank radius, rₚ and rₚₙ distance of the centre of mass of the present and the new plug from the crank axis</source>
        <translation>r — радиус кривошипа, rₚ и rₚₙ — расстояние центра масс существующей и новой заглушки от оси вала</translation>
    </message>
    <message>
        <source>Crankshaft made for new plugs, present plugs fitted</source>
        <translation>Вал под новые заглушки с существующими</translation>
    </message>
    <message>
        <source>Residual due to the shift of the centre of mass</source>
        <translation>Остаток от смещения центра масс</translation>
    </message>
    <message>
        <source>d distance of the bored metal from the centre of mass of the plug</source>
        <translation>d — расстояние снятого металла от центра масс заглушки</translation>
    </message>
    <message>
        <source>Not included: drilling in the webs, flywheel and damper.</source>
        <translation>Не учитываются: сверление щёк, маховик и гаситель колебаний.</translation>
    </message>
    <message>
        <source>The plug mass is from the paper: weigh the plugs.</source>
        <translation>Масса заглушки взята из статьи: взвесьте заглушки.</translation>
    </message>
    <message>
        <source>Large slow marine diesels whose crank drive is inherently unbalanced</source>
        <translation>Большие тихоходные судовые дизели с неуравновешенным по своей природе кривошипно-шатунным механизмом</translation>
    </message>
    <message>
        <source>Large slow marine diesels whose crank drive is inherently balanced</source>
        <translation>Большие тихоходные судовые дизели с уравновешенным по своей природе кривошипно-шатунным механизмом</translation>
    </message>
    <message>
        <source>Crank drives inherently unbalanced, on elastic mounts</source>
        <translation>Неуравновешенные по своей природе кривошипные механизмы на упругих опорах</translation>
    </message>
    <message>
        <source>Crank drives inherently unbalanced, rigidly mounted</source>
        <translation>Неуравновешенные по своей природе кривошипные механизмы на жёстких опорах</translation>
    </message>
    <message>
        <source>Complete engines of cars, trucks and locomotives</source>
        <translation>Двигатели легковых, грузовых автомобилей и локомотивов в сборе</translation>
    </message>
    <message>
        <source>Crank drives inherently balanced, on elastic mounts; wheels and drive shafts of cars</source>
        <translation>Уравновешенные кривошипные механизмы на упругих опорах; колёса и валы автомобилей</translation>
    </message>
    <message>
        <source>Crank drives inherently balanced, rigidly mounted; cardan shafts</source>
        <translation>Уравновешенные кривошипные механизмы на жёстких опорах; карданные валы</translation>
    </message>
    <message>
        <source>Machinery in general: flywheels, pumps, fans, turbochargers</source>
        <translation>Машины вообще: маховики, насосы, вентиляторы, турбокомпрессоры</translation>
    </message>
    <message>
        <source>Gas and steam turbines, machine-tool drives</source>
        <translation>Газовые и паровые турбины, приводы станков</translation>
    </message>
    <message>
        <source>Grinding machine drives</source>
        <translation>Приводы шлифовальных станков</translation>
    </message>
    <message>
        <source>Spindles of high-precision machines, gyroscopes</source>
        <translation>Шпиндели прецизионных станков, гироскопы</translation>
    </message>
    <message>
        <source>must be a list of %1 masses, one for each cylinder</source>
        <translation>должен быть списком масс по числу цилиндров (%1)</translation>
    </message>
    <message>
        <source>must be the numbers 1 to %1, each once</source>
        <translation>должны быть номера от 1 до %1, каждый один раз</translation>
    </message>
    <message>
        <source>Permissible residual unbalance</source>
        <translation>Допустимый остаточный дисбаланс</translation>
    </message>
    <message>
        <source>g·mm with the mass m in kg, the grade G in mm/s and the service speed ω in rad/s</source>
        <translation>г·мм при массе m в кг, классе G в мм/с и рабочей скорости ω в рад/с</translation>
    </message>
    <message>
        <source>Weigh-in</source>
        <translation>Взвешивание</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Среднее</translation>
    </message>
    <message>
        <source>Heaviest minus lightest.</source>
        <translation>Самая тяжёлая минус самая лёгкая.</translation>
    </message>
    <message>
        <source>Heaviest, cylinder</source>
        <translation>Самая тяжёлая, цилиндр</translation>
    </message>
    <message>
        <source>Lightest, cylinder</source>
        <translation>Самая лёгкая, цилиндр</translation>
    </message>
    <message>
        <source>Take off</source>
        <translation>Снять</translation>
    </message>
    <message>
        <source>Mean minus nominal</source>
        <translation>Среднее минус номинал</translation>
    </message>
    <message>
        <source>Sets moved</source>
        <translation>Переставлено комплектов</translation>
    </message>
    <message>
        <source>Proven</source>
        <translation>Доказано</translation>
    </message>
    <message>
        <source>Shaking before</source>
        <translation>Тряска до</translation>
    </message>
    <message>
        <source>Shaking</source>
        <translation>Тряска</translation>
    </message>
    <message>
        <source>Force, mass at the crank radius</source>
        <translation>Сила, масса на радиусе кривошипа</translation>
    </message>
    <message>
        <source>RMS at the ends</source>
        <translation>Среднеквадратичное на концах</translation>
    </message>
    <message>
        <source>Couple, mass at the crank radius</source>
        <translation>Момент, масса на радиусе кривошипа</translation>
    </message>
    <message>
        <source>Force, unbalance</source>
        <translation>Сила, дисбаланс</translation>
    </message>
    <message>
        <source>Couple, unbalance</source>
        <translation>Момент, дисбаланс</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Сила</translation>
    </message>
    <message>
        <source>Couple</source>
        <translation>Момент</translation>
    </message>
    <message>
        <source>Bob weight of the readings</source>
        <translation>Балансировочный груз показаний</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Строки</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Коэффициент</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Масса</translation>
    </message>
    <message>
        <source>%1: %2 looks like kilograms. Enter grams.</source>
        <translation>%1: %2 похоже на килограммы. Введите граммы.</translation>
    </message>
    <message>
        <source>Locks</source>
        <translation>Стопорные кольца</translation>
    </message>
    <message>
        <source>Oil</source>
        <translation>Масло</translation>
    </message>
    <message>
        <source>%1: cylinder %2 weighs %3, the others about %4. Weigh it again.</source>
        <translation>%1: цилиндр %2 — %3, остальные около %4. Взвесьте снова.</translation>
    </message>
    <message>
        <source>If the difference is permitted, enter the “permitted range” of the column.</source>
        <translation>Если разница допустима, задайте «допустимый размах» этого столбца.</translation>
    </message>
    <message>
        <source>%1: a slug of ⌀ %2 that is %3 long tilts when pressed in; it should be at least %4 long. Use a smaller slug diameter.</source>
        <translation>%1: вставку ⌀ %2 длиной %3 перекосит при запрессовке; длина должна быть не меньше %4. Возьмите вставку меньшего диаметра.</translation>
    </message>
    <message>
        <source>Rods of cylinders %1: the big end weighs less than the small end. Swap the columns or weigh the rods again.</source>
        <translation>Шатуны цилиндров %1: нижняя головка легче верхней. Поменяйте столбцы местами или взвесьте шатуны снова.</translation>
    </message>
    <message>
        <source>The big end of the rod, %1, weighs less than its small end, %2. Swap both or weigh the rod again.</source>
        <translation>Нижняя головка шатуна, %1, легче верхней, %2. Поменяйте их местами или взвесьте шатун снова.</translation>
    </message>
    <message>
        <source>The crankpins are unequal: their excess is %1 to %2, and the plugs are for the mean. Move the sets or match the parts first.</source>
        <translation>Шатунные шейки неодинаковы: их избыток от %1 до %2, а заглушки рассчитаны на среднее. Сначала переставьте комплекты или подберите детали.</translation>
    </message>
    <message>
        <source>A crankshaft of %1 is too heavy for this engine. Correct its mass in kilograms, or enter the limit in g·mm.</source>
        <translation>Коленчатый вал массой %1 слишком тяжёл для этого двигателя. Исправьте массу в килограммах или задайте допуск в г·мм.</translation>
    </message>
    <message>
        <source>The crankshaft with its bob weights, %1, weighs less than the bob weights, %2. Correct its mass.</source>
        <translation>Вал с балансировочными грузами, %1, легче самих грузов, %2. Исправьте его массу.</translation>
    </message>
    <message>
        <source>Clockwise</source>
        <translation>По часовой стрелке</translation>
    </message>
    <message>
        <source>Counter-clockwise</source>
        <translation>Против часовой стрелки</translation>
    </message>
    <message>
        <source>Light spot</source>
        <translation>Лёгкое место</translation>
    </message>
    <message>
        <source>Names of the planes</source>
        <translation>Названия плоскостей</translation>
    </message>
    <message>
        <source>Two names, as “front” and “rear” or “left” and “right”.</source>
        <translation>Два названия, например «перед» и «зад» или «левая» и «правая».</translation>
    </message>
    <message>
        <source>Degrees count</source>
        <translation>Отсчёт градусов</translation>
    </message>
    <message>
        <source>Machine shows</source>
        <translation>Станок показывает</translation>
    </message>
    <message>
        <source>Zero mark</source>
        <translation>Нулевая метка</translation>
    </message>
    <message>
        <source>Place of 0° on the crankshaft.</source>
        <translation>Место 0° на валу.</translation>
    </message>
    <message>
        <source>must be a list of two names</source>
        <translation>должно быть списком из двух названий</translation>
    </message>
    <message>
        <source>is allowed only for a V of 8 cylinders at 90° with two rods on a crankpin and no split</source>
        <translation>допускается только для V-образного двигателя с 8 цилиндрами под 90°, двумя шатунами на шейке и без разведения шеек</translation>
    </message>
    <message>
        <source>Plugs</source>
        <translation>Заглушки</translation>
    </message>
    <message>
        <source>Doubts</source>
        <translation>Сомнения</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <translation>Сомнительное</translation>
    </message>
    <message>
        <source>STOP. %1</source>
        <translation>СТОП. %1</translation>
    </message>
    <message>
        <source>Enter the missing values of engine and parts.</source>
        <translation>Введите недостающие данные двигателя и деталей.</translation>
    </message>
    <message>
        <source>Fails: %1 %5, %2 %6; permissible %3 and %4.</source>
        <translation>Не годен: %5 %1, %6 %2; допустимо %3 и %4.</translation>
    </message>
    <message>
        <source>Passes: %1 %5, %2 %6; permissible %3 and %4.</source>
        <translation>Годен: %5 %1, %6 %2; допустимо %3 и %4.</translation>
    </message>
    <message>
        <source>The readings are of another crankshaft: number %1 then, %2 now. Measure again.</source>
        <translation>Показания относятся к другому коленчатому валу: тогда номер %1, сейчас %2. Измерьте снова.</translation>
    </message>
    <message>
        <source>The readings were taken with another bob weight: %1 then, %2 now. Measure again.</source>
        <translation>Показания сняты с другим балансировочным грузом: тогда %1, сейчас %2. Измерьте снова.</translation>
    </message>
    <message>
        <source>Within permitted range</source>
        <translation>В пределах допустимого размаха</translation>
    </message>
    <message>
        <source>Matching of the parts</source>
        <translation>Подбор деталей</translation>
    </message>
    <message>
        <source>Range of the crankpins before</source>
        <translation>Размах шатунных шеек до</translation>
    </message>
    <message>
        <source>Range of the crankpins</source>
        <translation>Размах шатунных шеек</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Всего</translation>
    </message>
    <message>
        <source>%1: %2 entered, but %3 weighed. Correct the wrong value.</source>
        <translation>%1: введено %2, но взвешено %3. Исправьте неверное.</translation>
    </message>
    <message>
        <source>%1: nominal %2, but %3 weighed. Correct the wrong value.</source>
        <translation>%1: номинал %2, но взвешено %3. Исправьте неверное.</translation>
    </message>
    <message>
        <source>A balance factor of %1 looks like a fraction. Enter percent: 50 for one half.</source>
        <translation>Коэффициент балансировки %1 похож на долю единицы. Введите проценты: 50 для половины.</translation>
    </message>
    <message>
        <source>%1: %2 entered, but the nominal parts add up to %3. Correct the wrong value.</source>
        <translation>%1: введено %2, но сумма номинальных деталей %3. Исправьте неверное.</translation>
    </message>
    <message>
        <source>%1: range %2, permitted %3 (heaviest: cylinder %4, lightest: %5).</source>
        <translation>%1: размах %2, допускается %3 (самая тяжёлая: цилиндр %4, самая лёгкая: %5).</translation>
    </message>
    <message>
        <source>%1: range %2 (heaviest: cylinder %3, lightest: %4). Weigh them again or match the parts.</source>
        <translation>%1: размах %2 (самая тяжёлая: цилиндр %3, самая лёгкая: %4). Взвесьте ещё раз или подберите детали.</translation>
    </message>
    <message>
        <source>Reciprocating mass %1 and rotating mass %2 of a cylinder are inconsistent. Check the masses of the parts.</source>
        <translation>Возвратно-поступательная масса %1 и вращающаяся %2 одного цилиндра не согласуются. Проверьте массы деталей.</translation>
    </message>
    <message>
        <source>%1: drilling increased the unbalance to %2 instead of %3. Mark holes on the wrong side, or check whether the machine shows the light spot.</source>
        <translation>%1: сверление увеличило дисбаланс до %2 вместо %3. Отметьте отверстия, просверленные не с той стороны, или проверьте, не показывает ли станок лёгкое место.</translation>
    </message>
    <message>
        <source>%1: residual %2 after drilling instead of %3. Check the actual holes: angle, depth, zero mark and direction of degrees.</source>
        <translation>%1: остаток после сверления %2 вместо %3. Проверьте, как просверлено: угол, глубину, нулевую метку и направление отсчёта.</translation>
    </message>
    <message>
        <source>%1: residual %2 after drilling instead of %3. Check the actual angle and depth of the holes before drilling again.</source>
        <translation>%1: остаток после сверления %2 вместо %3. Прежде чем сверлить снова, проверьте действительные угол и глубину отверстий.</translation>
    </message>
    <message>
        <source>The readings are not in the planes. Enter their angles.</source>
        <translation>Показания сняты не в плоскостях коррекции. Введите их углы.</translation>
    </message>
    <message>
        <source>A service speed of %1 is implausible. Correct the speed.</source>
        <translation>Рабочая частота %1 неправдоподобна. Исправьте её.</translation>
    </message>
    <message>
        <source>The bearings are in reverse order to the planes. Measure all positions from one point in one direction.</source>
        <translation>Подшипники расположены в обратном порядке относительно плоскостей. Измерьте все положения от одной точки в одном направлении.</translation>
    </message>
    <message>
        <source>%1: a drilling radius of %2 does not match a crank radius of %3. Enter the radius, not the diameter.</source>
        <translation>%1: радиус сверления %2 не соответствует радиусу кривошипа %3. Введите радиус, а не диаметр.</translation>
    </message>
    <message>
        <source>The machine reads far outside the planes: errors may be %1 times as large in the planes. Measure nearer to the planes.</source>
        <translation>Станок измеряет далеко от плоскостей: погрешность показаний в них может быть в %1 раза больше. Измеряйте ближе к плоскостям.</translation>
    </message>
    <message>
        <source>%1: the edge of a hole is %2 beyond the drilling sector. Check that there is enough metal.</source>
        <translation>%1: край отверстия выходит за сектор сверления на %2. Проверьте, достаточно ли там металла.</translation>
    </message>
    <message>
        <source>Sludge-trap plugs of a V-8, as in the module v8-plugs, without its weigh-in, balancing and job.</source>
        <translation>Заглушки грязеуловителей V-8, как в модуле v8-plugs, без взвешивания, станка и работы.</translation>
    </message>
    <message>
        <source>Settings of the balancing machine.</source>
        <translation>Настройка балансировочного станка.</translation>
    </message>
    <message>
        <source>Direction seen from the front of the crankshaft.</source>
        <translation>Направление, если смотреть спереди вала.</translation>
    </message>
    <message>
        <source>Spot shown by the machine; holes are always planned at the heavy spot.</source>
        <translation>Место, которое показывает станок; отверстия всегда планируются в тяжёлом месте.</translation>
    </message>
    <message>
        <source>must be left out with plugs</source>
        <translation>не указывается, если заданы заглушки</translation>
    </message>
    <message>
        <source>%1: the holes drilled after %2 are opposite this heavy spot. Check their angles, and whether the machine shows the heavy or the light spot.</source>
        <translation>%1: отверстия, просверленные после показания %2, находятся напротив этого тяжёлого места. Проверьте их углы, а также тяжёлое или лёгкое место показывает станок.</translation>
    </message>
    <message>
        <source>Older holes, %1</source>
        <translation>Прежние отверстия, %1</translation>
    </message>
    <message>
        <source>Before, %1</source>
        <translation>Исходно, %1</translation>
    </message>
    <message>
        <source>Run %2, %1</source>
        <translation>Пуск %2, %1</translation>
    </message>
    <message>
        <source>%1: enter the angle.</source>
        <translation>%1: введите угол.</translation>
    </message>
    <message>
        <source>%1: enter the unbalance.</source>
        <translation>%1: введите дисбаланс.</translation>
    </message>
    <message>
        <source>Holes are recorded after “Before”: enter the readings of Run 1, or mark the holes as not drilled.</source>
        <translation>После пуска «Исходно» записаны отверстия: введите показания пуска 1 или отметьте отверстия как непросверленные.</translation>
    </message>
    <message>
        <source>Holes are recorded after Run %1: enter the readings of Run %2, or mark the holes as not drilled.</source>
        <translation>После пуска %1 записаны отверстия: введите показания пуска %2 или отметьте отверстия как непросверленные.</translation>
    </message>
    <message>
        <source>%1: the hole of ⌀ %2 at %3 is %4 deep after deepening, which is not deeper than before. Correct its depth.</source>
        <translation>%1: отверстие ⌀ %2 на %3 после углубления имеет глубину %4, то есть не глубже прежнего. Исправьте его глубину.</translation>
    </message>
    <message>
        <source>%1: residual %2 after drilling instead of %3. Measure the depth of the hole at %4 before deepening it, and record it as measured.</source>
        <translation>%1: остаток после сверления %2 вместо %3. Прежде чем углублять отверстие на %4, измерьте его глубину и запишите её по измерению.</translation>
    </message>
    <message>
        <source>%1: the recorded hole at %2 is outside the drilling sector. Check both.</source>
        <translation>%1: записанное отверстие на %2 находится вне сектора сверления. Проверьте отверстие и сектор.</translation>
    </message>
    <message>
        <source>%1: enter “%2”, the other end of the drilling sector.</source>
        <translation>%1: введите «%2», другую границу сектора сверления.</translation>
    </message>
    <message>
        <source>Drilling radii of %1 and %2: one looks like a diameter. Check both.</source>
        <translation>Радиусы сверления %1 и %2: один похож на диаметр. Проверьте оба.</translation>
    </message>
    <message>
        <source>%1: %2 does not match a crank radius of %3. Correct the wrong value.</source>
        <translation>%1: %2 не соответствует радиусу кривошипа %3. Исправьте неверное значение.</translation>
    </message>
    <message>
        <source>%1: a recorded hole is %2 deep, the maximum depth is %3. Correct the wrong value.</source>
        <translation>%1: записано отверстие глубиной %2, максимальная глубина %3. Исправьте неверное значение.</translation>
    </message>
    <message>
        <source>The front plane is named “%1”, the rear plane “%2”. Correct the names.</source>
        <translation>Передняя плоскость названа «%1», задняя «%2». Исправьте названия.</translation>
    </message>
    <message>
        <source>The front plane is named “%1”, the rear plane “%2”. Check that the readings are entered in this order.</source>
        <translation>Передняя плоскость названа «%1», задняя «%2». Проверьте, что показания введены в этом порядке.</translation>
    </message>
    <message>
        <source>Part number</source>
        <translation>Номер детали</translation>
    </message>
    <message>
        <source>%1: cylinders %2 differ from the others (%3, others %4). Weigh them again or match the parts.</source>
        <translation>%1: цилиндры %2 отличаются от остальных (%3, остальные %4). Взвесьте их снова или подберите детали.</translation>
    </message>
    <message>
        <source>%1: cylinder %2 weighs %3, the others about %4; the deviation is more than %5 times their scatter. Weigh it again or match the parts.</source>
        <translation>%1: цилиндр %2 — %3, остальные около %4; отклонение больше их разброса более чем в %5 раз. Взвесьте снова или подберите детали.</translation>
    </message>
    <message>
        <source>%1: %2 of 8 weighed. Weigh all of them, or clear the column.</source>
        <translation>%1: взвешено %2 из 8. Взвесьте все или очистите столбец.</translation>
    </message>
    <message>
        <source>Provisional. %1</source>
        <translation>Предварительно. %1</translation>
    </message>
    <message>
        <source>Provisional: not weighed and taken as nominal: %1. Weigh them before machining.</source>
        <translation>Предварительно: не взвешены и взяты по номиналу: %1. Взвесьте их до обработки.</translation>
    </message>
    <message>
        <source>%1: %2 is implausible for a crankshaft of %3. Check the unit of the reading and the calibration of the machine.</source>
        <translation>%1: %2 неправдоподобно для вала массой %3. Проверьте единицу показания и калибровку станка.</translation>
    </message>
    <message>
        <source>A drill of %1 is unusual. Separate several sizes by semicolons.</source>
        <translation>Сверло %1 необычно. Несколько размеров разделяйте точкой с запятой.</translation>
    </message>
    <message>
        <source>%1: the hole at %2 was planned to take off %3; with the present radius, density and drill point it takes off %4. Check them, or record the hole as measured.</source>
        <translation>%1: отверстие на %2 по плану снимало %3; с нынешними радиусом, плотностью и углом сверла оно снимает %4. Проверьте их или отметьте отверстие как измеренное.</translation>
    </message>
    <message>
        <source>The holes were drilled while the machine counted degrees in the other direction. Check the direction, or enter the angles as measured.</source>
        <translation>Отверстия просверлены, когда станок отсчитывал градусы в другую сторону. Проверьте направление отсчёта или введите измеренные углы.</translation>
    </message>
    <message>
        <source>%1: residual %2 after drilling instead of %3, as if the holes were in the other plane. Enter the actual plane of each hole.</source>
        <translation>%1: после сверления остаток %2 вместо %3, как если бы отверстия были в другой плоскости. Укажите плоскость, в которой находится каждое отверстие.</translation>
    </message>
    <message>
        <source>%1: enter the drilling sector, or 0 to 360° for a whole rim.</source>
        <translation>%1: введите сектор сверления или 0 и 360° для всей окружности.</translation>
    </message>
    <message>
        <source>The first readings are far below the limit. If the machine shows grams, enter them with their unit: %1.</source>
        <translation>Первые показания намного меньше допуска. Если станок показывает граммы, вводите их с единицей: %1.</translation>
    </message>
    <message>
        <source>See the warnings.</source>
        <translation>См. предупреждения.</translation>
    </message>
    <message>
        <source>%1: a drilling radius of %2 is unusual for such a bob weight. Enter the radius, not the diameter.</source>
        <translation>%1: радиус сверления %2 необычен для такого груза. Введите радиус, а не диаметр.</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3, but no hole is recorded. Enter the holes drilled, or check crankshaft and machine.</source>
        <translation>%1: %2 вместо %3, но сверления не записаны. Введите просверленные отверстия или проверьте коленвал и станок.</translation>
    </message>
    <message>
        <source>The readings need a known bob weight. Complete engine and parts.</source>
        <translation>Для показаний нужна известная масса балансировочного груза. Заполните двигатель и детали.</translation>
    </message>
    <message>
        <source>Oil of %1 in a crankpin is implausible for a bob weight of %2. Correct the oil.</source>
        <translation>Масло в шейке, %1, неправдоподобно при балансировочном грузе %2. Исправьте массу масла.</translation>
    </message>
    <message>
        <source>A balance grade of G %1 is implausible for this crankshaft. Correct it, or enter the limit in g·mm.</source>
        <translation>Класс точности G %1 неправдоподобен для этого вала. Исправьте его или введите допуск в г·мм.</translation>
    </message>
    <message>
        <source>%1: %2 is implausible at a drilling radius of %3. Correct the wrong value.</source>
        <translation>%1: %2 неправдоподобно при радиусе сверления %3. Исправьте неверное значение.</translation>
    </message>
    <message>
        <source>%1 at %2 is not before %3 at %4. Correct the positions of the planes.</source>
        <translation>%1 (%2) не впереди другой: %3 (%4). Исправьте положения плоскостей.</translation>
    </message>
    <message>
        <source>The first reading is at %1, the second at %2, but the planes are at %3 and %4. Correct the positions of the readings.</source>
        <translation>Первое показание снято на %1, второе на %2, а плоскости на %3 и %4. Исправьте места показаний.</translation>
    </message>
    <message>
        <source>%1 of %2 beside %3 of %4 is implausible. Correct the wrong value.</source>
        <translation>Неправдоподобно: %1 — %2, %3 — %4. Исправьте неверное значение.</translation>
    </message>
    <message>
        <source>The centre of mass is not between the bearings (or planes). Correct its position.</source>
        <translation>Центр масс не между подшипниками (плоскостями). Исправьте его положение.</translation>
    </message>
    <message>
        <source>Take %1 off each of the 8 steel plugs.</source>
        <translation>Снять с каждой из 8 стальных заглушек %1.</translation>
    </message>
    <message>
        <source>over-compensates by %1 on each crankpin</source>
        <translation>снимает на каждой шейке на %1 больше нужного</translation>
    </message>
    <message>
        <source>%1, within the %2 allowed</source>
        <translation>%1 при допустимых %2</translation>
    </message>
    <message>
        <source>%1 against the %2 allowed</source>
        <translation>%1 вместо допустимых %2</translation>
    </message>
    <message>
        <source>Crank radius r</source>
        <translation>Радиус кривошипа r</translation>
    </message>
    <message>
        <source>Aluminium plugs</source>
        <translation>Алюминиевые заглушки</translation>
    </message>
    <message>
        <source>New crankshaft, aluminium plugs</source>
        <translation>Новый вал, алюминиевые заглушки</translation>
    </message>
    <message>
        <source>Piston</source>
        <translation>Поршень</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Палец</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>Кольца</translation>
    </message>
    <message>
        <source>Rod, big end</source>
        <translation>Шатун, низ</translation>
    </message>
    <message>
        <source>Rod, small end</source>
        <translation>Шатун, верх</translation>
    </message>
    <message>
        <source>Shells</source>
        <translation>Вкладыши</translation>
    </message>
    <message>
        <source>Manufacture</source>
        <translation>Изготовление</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Ремонт</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Штатный</translation>
    </message>
    <message>
        <source>Made for plugs of the new design</source>
        <translation>Под новые заглушки</translation>
    </message>
    <message>
        <source>No plug of this crankshaft can be made light enough.</source>
        <translation>Ни одну заглушку этого вала нельзя облегчить достаточно.</translation>
    </message>
    <message>
        <source>Bore %1 deeper with a cutter of %2, to %3 from the face.</source>
        <translation>Углубить на %1 фрезой %2, до %3 от торца.</translation>
    </message>
    <message>
        <source>Bore with a cutter of %1 to %2 from the face.</source>
        <translation>Расточить фрезой %1 на глубину %2 от торца.</translation>
    </message>
    <message>
        <source>works</source>
        <translation>годится</translation>
    </message>
    <message>
        <source>works: %1</source>
        <translation>годится: %1</translation>
    </message>
    <message>
        <source>This %1: %2.</source>
        <translation>Это %1: %2.</translation>
    </message>
    <message>
        <source>From the crank axis to the centre of mass of a plug of the new design.</source>
        <translation>От оси вала до центра масс заглушки новой конструкции.</translation>
    </message>
    <message>
        <source>Oil in the sludge trap of one crankpin of a running engine.</source>
        <translation>Масло в грязесборнике одной шатунной шейки работающего двигателя.</translation>
    </message>
    <message>
        <source>Nominal mass of piston, pin, rings and the small-end share of the rod, one cylinder.</source>
        <translation>Номинальная масса поршня, пальца, колец и доли шатуна у пальца, один цилиндр.</translation>
    </message>
    <message>
        <source>Nominal mass of the rod&apos;s big end and its shells, one cylinder.</source>
        <translation>Номинальная масса нижней головки шатуна с вкладышами, один цилиндр.</translation>
    </message>
    <message>
        <source>must be null or left out where %1 is null</source>
        <translation>должно быть null или отсутствовать там, где %1 — null</translation>
    </message>
    <message>
        <source>must be an engine object or one of %1</source>
        <translation>должно быть объектом двигателя или одним из %1</translation>
    </message>
    <message>
        <source>is allowed only where engine is the name of a preset</source>
        <translation>допустимо, только если engine — имя образца</translation>
    </message>
    <message>
        <source>must be &quot;standard&quot; where the engine has no plug of the new design</source>
        <translation>должно быть &quot;standard&quot;, если у двигателя нет заглушки новой конструкции</translation>
    </message>
    <message>
        <source>is required and missing: the preset %1 does not give it</source>
        <translation>обязательно, но отсутствует: в образце %1 его нет</translation>
    </message>
    <message>
        <source>must be less than the plug&apos;s mass %1</source>
        <translation>должно быть меньше массы заглушки %1</translation>
    </message>
    <message>
        <source>is required where the bore&apos;s other size is given</source>
        <translation>обязательно, если задан другой размер полости</translation>
    </message>
    <message>
        <source>must be a possible plug: %1</source>
        <translation>такой заглушки быть не может: %1</translation>
    </message>
    <message>
        <source>Engines of the paper by displacement.</source>
        <translation>Двигатели статьи по рабочему объёму.</translation>
    </message>
    <message>
        <source>other</source>
        <translation>другой</translation>
    </message>
    <message>
        <source>&amp;Work</source>
        <translation>Вид &amp;работы</translation>
    </message>
    <message>
        <source>Cran&amp;kshaft</source>
        <translation>&amp;Коленчатый вал</translation>
    </message>
    <message>
        <source>Source of the mass changes</source>
        <translation>Источник изменений масс</translation>
    </message>
    <message>
        <source>Permissible residu&amp;al unbalance</source>
        <translation>Допустимый остаточный дис&amp;баланс</translation>
    </message>
    <message>
        <source>&amp;Thread</source>
        <translation>&amp;Резьба</translation>
    </message>
    <message>
        <source>Metric thread with its pitch, like M22x1.5.</source>
        <translation>Метрическая резьба с шагом, например M22×1,5.</translation>
    </message>
    <message>
        <source>&amp;Height h</source>
        <translation>&amp;Высота h</translation>
    </message>
    <message>
        <source>&amp;Bore diameter</source>
        <translation>&amp;Диаметр полости</translation>
    </message>
    <message>
        <source>Bore de&amp;pth</source>
        <translation>&amp;Глубина полости</translation>
    </message>
    <message>
        <source>&amp;Cutter diameter</source>
        <translation>Диаметр &amp;фрезы</translation>
    </message>
    <message>
        <source>&amp;Steel</source>
        <translation>С&amp;таль</translation>
    </message>
    <message>
        <source>Carbon steel 7850 kg/m³.</source>
        <translation>Углеродистая сталь 7850 кг/м³.</translation>
    </message>
    <message>
        <source>&amp;Aluminium</source>
        <translation>&amp;Алюминий</translation>
    </message>
    <message>
        <source>Wrought alloys 2640 to 2850 kg/m³.</source>
        <translation>Деформируемые сплавы 2640–2850 кг/м³.</translation>
    </message>
    <message>
        <source>&amp;Grade G</source>
        <translation>&amp;Класс G</translation>
    </message>
    <message>
        <source>Service s&amp;peed</source>
        <translation>&amp;Частота вращения</translation>
    </message>
    <message>
        <source>&amp;Front plane (pulley)</source>
        <translation>&amp;Передняя плоскость (шкив)</translation>
    </message>
    <message>
        <source>Residual unbalance after correction.</source>
        <translation>Остаточный дисбаланс после коррекции.</translation>
    </message>
    <message>
        <source>&amp;Rear plane (flywheel)</source>
        <translation>&amp;Задняя плоскость (маховик)</translation>
    </message>
    <message>
        <source>Engine &amp;number</source>
        <translation>&amp;Номер двигателя</translation>
    </message>
    <message>
        <source>Crankshaft num&amp;ber</source>
        <translation>Номер &amp;вала</translation>
    </message>
    <message>
        <source>C&amp;ustomer</source>
        <translation>&amp;Заказчик</translation>
    </message>
    <message>
        <source>&amp;Date</source>
        <translation>&amp;Дата</translation>
    </message>
    <message>
        <source>Year-month-day or day.month.year.</source>
        <translation>Год-месяц-день или день.месяц.год.</translation>
    </message>
    <message>
        <source>&amp;Technician</source>
        <translation>&amp;Исполнитель</translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation>П&amp;римечания</translation>
    </message>
    <message>
        <source>must be a metric thread with its pitch, like %1</source>
        <translation>должно быть метрической резьбой с шагом, например %1</translation>
    </message>
    <message>
        <source>the diameter %1 mm</source>
        <translation>диаметр %1 мм</translation>
    </message>
    <message>
        <source>the pitch %1 mm and a third of the diameter</source>
        <translation>шаг %1 мм и трети диаметра</translation>
    </message>
    <message>
        <source>Take %1 off each of the 8 new steel plugs.</source>
        <translation>Снять с каждой из 8 новых стальных заглушек %1.</translation>
    </message>
    <message>
        <source>New crankshaft, its own plugs</source>
        <translation>Новый вал, его заглушки</translation>
    </message>
    <message>
        <source>Nominal mass of the part.</source>
        <translation>Номинальная масса детали.</translation>
    </message>
    <message>
        <source>Sizes of the plug.</source>
        <translation>Размеры заглушки.</translation>
    </message>
    <message>
        <source>Limits and readings of the balancing machine.</source>
        <translation>Нормы и показания балансировочного станка.</translation>
    </message>
    <message>
        <source>Head of the job card.</source>
        <translation>Шапка карты.</translation>
    </message>
    <message>
        <source>Improved piston Δmₚᵢ</source>
        <translation>Поршень</translation>
    </message>
    <message>
        <source>Repair piston and rings Δmᵣₚ</source>
        <translation>Рем. поршень, кольца</translation>
    </message>
    <message>
        <source>Rod big end</source>
        <translation>Головка шатуна</translation>
    </message>
    <message>
        <source>Repair shells of one crankpin Δmₛₕ</source>
        <translation>Рем. вкладыши одной шатунной шейки Δmₛₕ</translation>
    </message>
    <message>
        <source>Repair shells Δmₛₕ</source>
        <translation>Рем. вкладыши</translation>
    </message>
    <message>
        <source>Oil mₘ</source>
        <translation>Масло mₘ</translation>
    </message>
    <message>
        <source>Plug radius rₚ</source>
        <translation>Радиус заглушки rₚ</translation>
    </message>
    <message>
        <source>New plug radius rₚₙ</source>
        <translation>Радиус новой заглушки rₚₙ</translation>
    </message>
    <message>
        <source>Rod coefficient kᵣ</source>
        <translation>Коэффициент шатуна kᵣ</translation>
    </message>
    <message>
        <source>Oil coefficient kₘ</source>
        <translation>Коэффициент масла kₘ</translation>
    </message>
    <message>
        <source>is required where %1 is &quot;weigh-in&quot;</source>
        <translation>обязательно, если «%1» — &quot;weigh-in&quot;</translation>
    </message>
    <message>
        <source>V-8 of %1 litres</source>
        <translation>V-8, %1 л</translation>
    </message>
    <message>
        <source>a solid plug</source>
        <translation>сплошная заглушка</translation>
    </message>
    <message>
        <source>no boring is planned</source>
        <translation>без расточки</translation>
    </message>
    <message>
        <source>Typed</source>
        <translation>Введено</translation>
    </message>
    <message>
        <source>required</source>
        <translation>нужно</translation>
    </message>
    <message>
        <source>The two cylinders that share a crankpin.</source>
        <translation>Два цилиндра на одной шатунной шейке.</translation>
    </message>
    <message>
        <source>Balance quality grade of ISO 21940-11, 0.4 to 4000 mm/s. Engines of cars, trucks and locomotives: G 100; inherently balanced crankshafts: better.</source>
        <translation>Класс точности балансировки по ИСО 21940-11, от 0,4 до 4000 мм/с. Автомобильные и тепловозные двигатели: G 100; уравновешенные валы: точнее.</translation>
    </message>
    <message>
        <source>Maximum speed in service, not the speed of the machine.</source>
        <translation>Максимальная рабочая частота, а не частота станка.</translation>
    </message>
    <message>
        <source>The journal finds the job by this number.</source>
        <translation>По этому номеру журнал находит работу.</translation>
    </message>
    <message>
        <source>Number stamped on the crankshaft.</source>
        <translation>Номер, выбитый на валу.</translation>
    </message>
    <message>
        <source>Engine and crankshaft of the readings, if the job now names others.</source>
        <translation>Двигатель и вал показаний, если в работе теперь указаны другие.</translation>
    </message>
    <message>
        <source>Engine number of the reading</source>
        <translation>Номер двигателя при показании</translation>
    </message>
    <message>
        <source>Number of the engine during the reading.</source>
        <translation>Номер двигателя при измерении.</translation>
    </message>
    <message>
        <source>Crankshaft number of the reading</source>
        <translation>Номер вала при показании</translation>
    </message>
    <message>
        <source>Number of the crankshaft during the reading.</source>
        <translation>Номер вала при измерении.</translation>
    </message>
    <message>
        <source>Owner of the engine; the journal finds the job by this name.</source>
        <translation>Владелец двигателя; по этому имени журнал находит работу.</translation>
    </message>
    <message>
        <source>Name of the technician.</source>
        <translation>Имя исполнителя.</translation>
    </message>
    <message>
        <source>Notes on the job card.</source>
        <translation>Примечания на карте.</translation>
    </message>
    <message>
        <source>Masses of the parts by the scale.</source>
        <translation>Массы деталей по весам.</translation>
    </message>
    <message>
        <source>Permitted range of the masses.</source>
        <translation>Допустимый размах масс.</translation>
    </message>
    <message>
        <source>Piston set in each cylinder, by the cylinder where it was weighed.</source>
        <translation>Комплект поршня в каждом цилиндре: номер цилиндра, где он взвешен.</translation>
    </message>
    <message>
        <source>Rod in each cylinder, by the cylinder where it was weighed.</source>
        <translation>Шатун в каждом цилиндре: номер цилиндра, где он взвешен.</translation>
    </message>
    <message>
        <source>Bob weight of the reading</source>
        <translation>Груз при показании</translation>
    </message>
    <message>
        <source>Bob weight on each crankpin during the reading; the reading is valid only with it.</source>
        <translation>Груз на каждой шатунной шейке при измерении; показание верно только с ним.</translation>
    </message>
    <message>
        <source>Leave the 8 new steel plugs unchanged.</source>
        <translation>Оставить 8 новых стальных заглушек без изменений.</translation>
    </message>
    <message>
        <source>Fit the 8 present steel plugs unchanged.</source>
        <translation>Поставить 8 существующих стальных заглушек без доработки.</translation>
    </message>
    <message>
        <source>Replace all 8 plugs by aluminium plugs, lightened by %1 each.</source>
        <translation>Заменить все 8 заглушек алюминиевыми, сняв с каждой %1.</translation>
    </message>
    <message>
        <source>Replace all 8 plugs by aluminium plugs, unchanged.</source>
        <translation>Заменить все 8 заглушек алюминиевыми без доработки.</translation>
    </message>
    <message>
        <source>leaves an excess of %1 on each crankpin</source>
        <translation>оставляет на каждой шейке лишние %1</translation>
    </message>
    <message>
        <source>Leave the plugs unchanged: the excess of %1 per crankpin is %2.</source>
        <translation>Заглушки оставить без изменений: лишние %1 на шейку дают %2.</translation>
    </message>
    <message>
        <source>The crankshaft is made for plugs of the new design: enter their mass and radius.</source>
        <translation>Вал изготовлен под новые заглушки: введите их массу и радиус.</translation>
    </message>
    <message>
        <source>The parts are %1 per crankpin lighter than nominal (%2). Plugs can only be lightened: use heavier parts or heavier plugs.</source>
        <translation>Детали легче номинала на %1 на шейку (%2). Заглушки можно только облегчить: нужны более тяжёлые детали или заглушки.</translation>
    </message>
    <message>
        <source>“%1” would be suitable with %2 off each plug, but such a plug cannot be made.</source>
        <translation>«%1» подошло бы со снятием %2 с каждой заглушки, но такую заглушку не изготовить.</translation>
    </message>
    <message>
        <source>“%1” would be suitable, but such a plug cannot be made.</source>
        <translation>«%1» подошло бы, но такую заглушку не изготовить.</translation>
    </message>
    <message>
        <source>No plug of this crankshaft has the required mass.</source>
        <translation>Ни одна заглушка этого вала не даёт нужной массы.</translation>
    </message>
    <message>
        <source>The nearest option is “%1”, which %2: %3.</source>
        <translation>Ближе всего «%1»: %2, то есть %3.</translation>
    </message>
    <message>
        <source>Also take %1 off each piston.</source>
        <translation>Вместе с этим снимите по %1 с каждого поршня.</translation>
    </message>
    <message>
        <source>A crankshaft for the new plugs would be suitable: “%1”.</source>
        <translation>Подошёл бы вал под новые заглушки: «%1».</translation>
    </message>
    <message>
        <source>A standard crankshaft would be suitable: “%1”.</source>
        <translation>Подошёл бы штатный вал: «%1».</translation>
    </message>
    <message>
        <source>Machine the steel plugs</source>
        <translation>Облегчить стальные заглушки</translation>
    </message>
    <message>
        <source>New crankshaft, steel plugs</source>
        <translation>Новый вал, стальные заглушки</translation>
    </message>
    <message>
        <source>From the crank axis to the centre of mass of the present plug.</source>
        <translation>От оси вала до центра масс существующей заглушки.</translation>
    </message>
    <message>
        <source>Mass of one plug by the scale, before machining.</source>
        <translation>Масса одной заглушки по показанию весов, до обработки.</translation>
    </message>
    <message>
        <source>Mass of one plug of the new design, for which the counterweights are made.</source>
        <translation>Масса одной заглушки новой конструкции, под которую сделаны противовесы вала.</translation>
    </message>
    <message>
        <source>Maximum to take off one plug, by the strength of its walls.</source>
        <translation>Максимум, который можно снять с одной заглушки по прочности стенок.</translation>
    </message>
    <message>
        <source>Masses of the parts</source>
        <translation>Массы деталей</translation>
    </message>
    <message>
        <source>Values that replace or complete the preset.</source>
        <translation>Значения, которые заменяют или дополняют образец.</translation>
    </message>
    <message>
        <source>In manufacture, repair pistons and repair shells are not used.</source>
        <translation>При изготовлении ремонтные поршни и вкладыши не учитываются.</translation>
    </message>
    <message>
        <source>Plugs for which the counterweights of the crankshaft were made.</source>
        <translation>Заглушки, под которые сделаны противовесы вала.</translation>
    </message>
    <message>
        <source>Mass of the parts minus nominal; negative if lighter.</source>
        <translation>Масса деталей минус номинал; отрицательна, если легче.</translation>
    </message>
    <message>
        <source>Source of the changes: weighed masses, or the changes typed on the sheet.</source>
        <translation>Источник изменений: взвешенные массы или изменения, введённые на листе.</translation>
    </message>
    <message>
        <source>Limit in each correction plane. Nazarov&apos;s experiments left 5 g·mm; a repair manual may allow much more (2 oz·in is 1440 g·mm).</source>
        <translation>Предел в каждой плоскости коррекции. В опытах Назарова оставалось 5 г·мм; руководство по ремонту может допускать намного больше (2 унции·дюйма — 1440 г·мм).</translation>
    </message>
    <message>
        <source>Height of the whole plug.</source>
        <translation>Высота всей заглушки.</translation>
    </message>
    <message>
        <source>Diameter of the present bore.</source>
        <translation>Диаметр имеющейся полости.</translation>
    </message>
    <message>
        <source>Depth from the outer face.</source>
        <translation>Глубина от наружного торца.</translation>
    </message>
    <message>
        <source>Minimum &amp;wall</source>
        <translation>Мин. &amp;стенка</translation>
    </message>
    <message>
        <source>Minimum between the bore and the root of the thread.</source>
        <translation>Минимум между полостью и впадиной резьбы.</translation>
    </message>
    <message>
        <source>Minimum b&amp;ottom</source>
        <translation>Мин. д&amp;но</translation>
    </message>
    <message>
        <source>Minimum between the bore and the inner face.</source>
        <translation>Минимум между полостью и внутренним торцом.</translation>
    </message>
    <message>
        <source>Bob weight of the reading, front</source>
        <translation>Груз при показании, спереди</translation>
    </message>
    <message>
        <source>Bob weight of the reading, rear</source>
        <translation>Груз при показании, сзади</translation>
    </message>
    <message>
        <source>Δmₚᵢ: one piston minus nominal.</source>
        <translation>Один поршень минус номинал.</translation>
    </message>
    <message>
        <source>One big end minus nominal.</source>
        <translation>Одна нижняя головка минус номинал.</translation>
    </message>
    <message>
        <source>Δmᵣₚ: one repair piston with rings minus nominal.</source>
        <translation>Один ремонтный поршень с кольцами минус номинал.</translation>
    </message>
    <message>
        <source>Δmₛₕ: repair shells of one crankpin minus nominal.</source>
        <translation>Ремонтные вкладыши одной шейки минус номинал.</translation>
    </message>
    <message>
        <source>%1: the typed %2 is not used in manufacture.</source>
        <translation>%1: введённое %2 при изготовлении не учитывается.</translation>
    </message>
    <message>
        <source>%1: the typed %2 is used with the weighed masses.</source>
        <translation>%1: введённое %2 учитывается вместе со взвешенным.</translation>
    </message>
    <message>
        <source>%1: the typed %2 is not used. Weighed masses are selected, but no column is complete.</source>
        <translation>%1: введённое %2 не используется. Выбраны взвешенные массы, но ни один столбец не полон.</translation>
    </message>
    <message>
        <source>Weighed masses are not used: the typed changes are selected.</source>
        <translation>Взвешенные массы не используются: выбраны введённые изменения.</translation>
    </message>
    <message>
        <source>%1: weighed masses need a nominal mass.</source>
        <translation>%1: взвешенным массам нужен номинал.</translation>
    </message>
    <message>
        <source>%1: %2 of 8 weighed; the typed change is used until all are weighed.</source>
        <translation>%1: взвешено %2 из 8; пока не все, используется введённое изменение.</translation>
    </message>
    <message>
        <source>%1: %2 of 8 weighed; nominal is used until all are weighed.</source>
        <translation>%1: взвешено %2 из 8; пока не все, используется номинал.</translation>
    </message>
    <message>
        <source>The bore is as deep as the plug: no bottom remains.</source>
        <translation>Полость глубиной с заглушку: дна не остаётся.</translation>
    </message>
    <message>
        <source>The bore is wider than the root of the thread, %1: no wall remains.</source>
        <translation>Полость шире впадины резьбы, %1: стенки не остаётся.</translation>
    </message>
    <message>
        <source>A cutter of %1 leaves a wall of %2 under the thread; the minimum is %3.</source>
        <translation>Фреза %1 оставляет под резьбой стенку %2; минимум %3.</translation>
    </message>
    <message>
        <source>A cutter of %1 needs a depth of %2; the bottom must be at least %3.</source>
        <translation>Фрезе %1 нужна глубина %2; дно должно быть не тоньше %3.</translation>
    </message>
    <message>
        <source>The paper&apos;s method alone would leave %1, permissible %2: it neglects the shift of the plug&apos;s centre of mass.</source>
        <translation>По одному методу статьи осталось бы %1, допустимо %2: он пренебрегает смещением центра масс заглушки.</translation>
    </message>
    <message>
        <source>The method neglects the shift of the plug&apos;s centre of mass, %3 to %4 in the paper: the residual is up to %1, permissible %2.</source>
        <translation>Метод пренебрегает смещением центра масс заглушки, в статье %3–%4: остаток до %1, допустимо %2.</translation>
    </message>
    <message>
        <source>Enter the plug&apos;s sizes and the cutter, or take off %1 each: the residual is then up to %2.</source>
        <translation>Введите размеры заглушки и фрезу или снимите по %1 с каждой заглушки: тогда остаток до %2.</translation>
    </message>
    <message>
        <source>Take off %1 each.</source>
        <translation>Снимите по %1 с каждой заглушки.</translation>
    </message>
    <message>
        <source>Big end × 2: the small ends are weighed, kᵣ is not used.</source>
        <translation>Головка × 2: верхние головки взвешены, kᵣ не учитывается.</translation>
    </message>
    <message>
        <source>Big end × %1: 2 for two rods, kᵣ = %2 by the method for the small ends, which are not weighed; effect here: %3, %4.</source>
        <translation>Головка × %1: 2 за два шатуна, kᵣ = %2 по методу за верхние головки, которые не взвешены; влияние здесь: %3, %4.</translation>
    </message>
    <message>
        <source>%1: %2 is the paper&apos;s limit for its plug; the walls of this plug allow %3. Enter the limit of this plug.</source>
        <translation>%1: %2 — предел статьи для её заглушки; стенки этой заглушки допускают %3. Введите предел этой заглушки.</translation>
    </message>
    <message>
        <source>%1: %2 is the paper&apos;s limit for its plug. Enter the limit of this plug.</source>
        <translation>%1: %2 — предел статьи для её заглушки. Введите предел этой заглушки.</translation>
    </message>
    <message>
        <source>Bore to %1 from the face, %2 off each plug.</source>
        <translation>Расточите на %1 от торца, по %2 с каждой заглушки.</translation>
    </message>
    <message>
        <source>One improved piston Δmₚᵢ</source>
        <translation>Один улучшенный поршень</translation>
    </message>
    <message>
        <source>Big end of one rod</source>
        <translation>Нижняя головка одного шатуна</translation>
    </message>
    <message>
        <source>One repair piston with rings Δmᵣₚ</source>
        <translation>Один рем. поршень с кольцами</translation>
    </message>
    <message>
        <source>One steel plug mₚ</source>
        <translation>Одна стальная заглушка mₚ</translation>
    </message>
    <message>
        <source>One aluminium plug mₐ</source>
        <translation>Одна алюминиевая заглушка mₐ</translation>
    </message>
    <message>
        <source>One new steel plug mₚₙ</source>
        <translation>Одна новая стальная mₚₙ</translation>
    </message>
    <message>
        <source>One new aluminium plug mₐₙ</source>
        <translation>Одна новая алюминиевая mₐₙ</translation>
    </message>
    <message>
        <source>Max. off one steel plug Δmₚₘ</source>
        <translation>Предел съёма с одной стальной Δmₚₘ</translation>
    </message>
    <message>
        <source>Max. off one aluminium plug Δmₐₘ</source>
        <translation>Предел с одной алюминиевой Δmₐₘ</translation>
    </message>
    <message>
        <source>Oil of one crankpin mₘ</source>
        <translation>Масло одной шейки mₘ</translation>
    </message>
    <message>
        <source>Reciprocating, one cylinder mⱼ</source>
        <translation>Поступательная, 1 цилиндр mⱼ</translation>
    </message>
    <message>
        <source>Rotating, one cylinder</source>
        <translation>Вращающаяся, 1 цилиндр</translation>
    </message>
    <message>
        <source>&amp;Mass with bob weights</source>
        <translation>&amp;Масса с грузами</translation>
    </message>
    <message>
        <source>Mass of crankshaft and bob weights on the machine.</source>
        <translation>Масса вала с грузами на станке.</translation>
    </message>
    <message>
        <source>A heavier big end has the factor (2 + k), unless the small ends are weighed.</source>
        <translation>Лишняя масса нижней головки учитывается с множителем (2 + k), если верхние головки не взвешены.</translation>
    </message>
    <message>
        <source>&amp;Share of the first plane</source>
        <translation>&amp;Доля первой плоскости</translation>
    </message>
    <message>
        <source>Factor of the oil mass in the bob weight; 1 if its centre is on the crankpin&apos;s axis.</source>
        <translation>Множитель массы масла в балансировочном грузе; 1, если её центр на оси шейки.</translation>
    </message>
    <message>
        <source>The limits contradict each other: %1.</source>
        <translation>Пределы противоречат друг другу: %1.</translation>
    </message>
    <message>
        <source>Plan when the job card was printed or the job put aside; its holes are recorded as drilled once the next run is read.</source>
        <translation>План на момент печати карты или откладывания работы; его отверстия записываются просверленными, когда снят следующий пуск.</translation>
    </message>
    <message>
        <source>Holes and slugs of that plan.</source>
        <translation>Отверстия и вставки этого плана.</translation>
    </message>
    <message>
        <source>The plan has changed since it was printed or put aside: %1. If these holes were drilled, enter the readings of the next run; if none was, use the present plan.</source>
        <translation>План изменился после печати или откладывания: %1. Если эти отверстия просверлены, введите показания следующего пуска; если ни одного — примите текущий план.</translation>
    </message>
</context>
<context>
    <name>V8</name>
    <message>
        <source>l</source>
        <comment>litre</comment>
        <translation>л</translation>
    </message>
    <message>
        <source>steel</source>
        <translation>сталь</translation>
    </message>
    <message>
        <source>aluminium</source>
        <translation>алюминий</translation>
    </message>
    <message>
        <source>%1: must be less than the plug&apos;s mass, %2.</source>
        <translation>%1: должно быть меньше массы заглушки, %2.</translation>
    </message>
    <message>
        <source>new: steel</source>
        <translation>новый: сталь</translation>
    </message>
    <message>
        <source>new: its own</source>
        <translation>новый: свои</translation>
    </message>
    <message>
        <source>new: aluminium</source>
        <translation>новый: алюм.</translation>
    </message>
    <message>
        <source>changes of mass (sheet 2) or masses of the parts (sheet 3)</source>
        <translation>изменения масс (лист 2) или массы деталей (лист 3)</translation>
    </message>
    <message>
        <source>Enter both diameter and depth of the bore.</source>
        <translation>Введите и диаметр, и глубину полости.</translation>
    </message>
    <message>
        <source>The method neglects the shift of the plug&apos;s centre of mass by boring, %4 to %5. Effect: %1 to %2; permissible: %3.</source>
        <translation>Метод пренебрегает смещением центра масс заглушки при расточке, от %4 до %5. Влияние: %1–%2; допустимо: %3.</translation>
    </message>
    <message>
        <source>With the planned bore it moves by %1: %2.</source>
        <translation>При этой расточке он смещается на %1: %2.</translation>
    </message>
    <message>
        <source>Without plugs; with the planned plugs use %1.</source>
        <translation>Без заглушек; с намеченными — %1.</translation>
    </message>
    <message>
        <source>Would match nominal, but cannot be made.</source>
        <translation>Совпало бы с номиналом, но изготовить нельзя.</translation>
    </message>
    <message>
        <source>Matches nominal within %1.</source>
        <translation>Совпадает с номиналом в пределах %1.</translation>
    </message>
    <message>
        <source>Matches nominal: balanced.</source>
        <translation>Совпадает с номиналом: уравновешено.</translation>
    </message>
    <message>
        <source>Difference from nominal: %1 (%2).</source>
        <translation>Отличие от номинала: %1 (%2).</translation>
    </message>
    <message>
        <source>Weighed to %1, the bob weight is accurate to ±%2 and the unbalance of a crankpin to ±%3 (95 %).</source>
        <translation>При взвешивании до %1 масса балансировочного груза известна до ±%2, а дисбаланс шейки — до ±%3 (95&#xa0;%).</translation>
    </message>
    <message>
        <source>This is enough for the tolerance of %1.</source>
        <translation>Для допуска %1 этого достаточно.</translation>
    </message>
    <message>
        <source>This is too coarse for the tolerance of %1: use a scale with a last digit of %2.</source>
        <translation>Для допуска %1 это слишком грубо: возьмите весы с дискретностью %2.</translation>
    </message>
    <message>
        <source>The values are inconsistent.</source>
        <translation>Значения не согласуются.</translation>
    </message>
    <message>
        <source>Missing for the plugs: %1.</source>
        <translation>Для заглушек не хватает: %1.</translation>
    </message>
</context>
<context>
    <name>Workshop</name>
    <message>
        <source>another bob weight</source>
        <translation>другой груз</translation>
    </message>
    <message>
        <source>another crankshaft</source>
        <translation>другой вал</translation>
    </message>
    <message>
        <source>%1 of cylinder %2</source>
        <translation>%1 цилиндра %2</translation>
    </message>
    <message>
        <source>rod of cylinder %1</source>
        <translation>шатун цилиндра %1</translation>
    </message>
    <message>
        <source>Weigh again first: %1.</source>
        <translation>Сначала взвесьте снова: %1.</translation>
    </message>
    <message>
        <source>PASS</source>
        <translation>ГОДЕН</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>НЕ ГОДЕН</translation>
    </message>
    <message>
        <source>FAIL → drill, then PASS</source>
        <translation>НЕ ГОДЕН → сверлить → ГОДЕН</translation>
    </message>
    <message>
        <source>FAIL → drill, still FAIL</source>
        <translation>НЕ ГОДЕН → сверлить → НЕ ГОДЕН</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>СТОП</translation>
    </message>
    <message>
        <source>PASS, but see the warnings</source>
        <translation>ГОДЕН, но есть предупреждения</translation>
    </message>
    <message>
        <source>FAIL: no hole is possible</source>
        <translation>НЕ ГОДЕН: сверлить негде</translation>
    </message>
</context>
<context>
    <name>ravnoves::AnswerLabel</name>
    <message>
        <source>Copy text</source>
        <translation>Копировать текст</translation>
    </message>
</context>
<context>
    <name>ravnoves::BalanceShaftModel</name>
    <message>
        <source>Torque source</source>
        <translation>Источник момента</translation>
    </message>
    <message>
        <source>Mᵤₚ</source>
        <translation>Mᵤₚ</translation>
    </message>
    <message>
        <source>Mₛ</source>
        <translation>Mₛ</translation>
    </message>
    <message>
        <source>Mᵤₚₛ</source>
        <translation>Mᵤₚₛ</translation>
    </message>
    <message>
        <source>change</source>
        <translation>измен.</translation>
    </message>
    <message>
        <source>range</source>
        <translation>размах</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>СКЗ</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>среднее</translation>
    </message>
    <message>
        <source>nodes</source>
        <translation>по узлам</translation>
    </message>
    <message>
        <source>max</source>
        <translation>макс.</translation>
    </message>
    <message>
        <source>min</source>
        <translation>мин.</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Величина</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Значение</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Ед.</translation>
    </message>
    <message>
        <source>First order&apos;s share of Mᵤₚ</source>
        <translation>Доля 1-го порядка в Mᵤₚ</translation>
    </message>
    <message>
        <source>Envelope, width × height</source>
        <translation>Габарит, ширина × высота</translation>
    </message>
    <message>
        <source>Torque table</source>
        <translation>Таблица момента</translation>
    </message>
    <message>
        <source>%1 better</source>
        <translation>%1 лучше</translation>
    </message>
    <message>
        <source>%1 worse</source>
        <translation>%1 хуже</translation>
    </message>
    <message>
        <source>Box around cylinder, crank circle, shaft circle, gears and wall in the front view</source>
        <translation>Прямоугольник вокруг цилиндра, окружностей кривошипа и вала, шестерён и стенки на виде спереди</translation>
    </message>
    <message>
        <source>Rebuild torque</source>
        <translation>Пересчитать</translation>
    </message>
    <message>
        <source>Tipping moment on the engine without a shaft, −Mᵢ</source>
        <translation>Опрокидывающий момент двигателя без вала, −Mᵢ</translation>
    </message>
    <message>
        <source>Moment of the shaft, P₁ l sin(α + φ)</source>
        <translation>Момент вала, P₁ l sin(α + φ)</translation>
    </message>
    <message>
        <source>Moment on the mounts with the shaft, Mᵤₚ + Mₛ</source>
        <translation>Момент на опорах с валом, Mᵤₚ + Mₛ</translation>
    </message>
    <message>
        <source>Change from Mᵤₚ to Mᵤₚₛ, relative to Mᵤₚ. Better: smaller range, RMS and maximum, minimum nearer to zero.</source>
        <translation>Изменение от Mᵤₚ к Mᵤₚₛ, в долях Mᵤₚ. Лучше: меньше размах, СКЗ и максимум, минимум ближе к нулю.</translation>
    </message>
    <message>
        <source>Maximum minus minimum over the cycle</source>
        <translation>Максимум минус минимум за цикл</translation>
    </message>
    <message>
        <source>RMS about the mean over the cycle</source>
        <translation>СКЗ относительно среднего за цикл</translation>
    </message>
    <message>
        <source>Mean over the cycle; for the shaft 0 at every α</source>
        <translation>Среднее за цикл; у вала оно 0 при любом α</translation>
    </message>
    <message>
        <source>Mean of table rows (paper), with the end of the cycle counted twice. It reproduces the paper&apos;s numbers only.</source>
        <translation>Среднее по строкам таблицы (статья), конец цикла учтён дважды. Оно лишь воспроизводит числа статьи.</translation>
    </message>
    <message>
        <source>Maximum over the cycle</source>
        <translation>Максимум за цикл</translation>
    </message>
    <message>
        <source>Minimum over the cycle; usually negative, nearer to zero is better</source>
        <translation>Минимум за цикл; обычно отрицательный, ближе к нулю лучше</translation>
    </message>
    <message>
        <source>Share of the mean square about the mean; only this share can be changed by a shaft at crank speed.</source>
        <translation>Доля среднего квадрата отклонения; только её может изменить вал, вращающийся со скоростью коленчатого.</translation>
    </message>
    <message>
        <source>speed fluctuates by ±</source>
        <translation>частота колеблется на ±</translation>
    </message>
    <message>
        <source>± half of δ n about the mean speed</source>
        <translation>± половина δ n от средней частоты</translation>
    </message>
    <message>
        <source>maximum speed at crank angle</source>
        <translation>максимум частоты при угле</translation>
    </message>
    <message>
        <source>Crank angle of the maximum excess energy</source>
        <translation>Угол максимума избыточной энергии</translation>
    </message>
    <message>
        <source>minimum speed at crank angle</source>
        <translation>минимум частоты при угле</translation>
    </message>
    <message>
        <source>Crank angle of the minimum excess energy</source>
        <translation>Угол минимума избыточной энергии</translation>
    </message>
    <message>
        <source>α has no effect.</source>
        <translation>α не влияет.</translation>
    </message>
    <message>
        <source>
but at this l no α is feasible</source>
        <translation>
но при этом l допустимых α нет</translation>
    </message>
    <message>
        <source>%1° would give %2 less but does not fit</source>
        <translation>%1° дал бы на %2 меньше, но не помещается</translation>
    </message>
    <message>
        <source>Minimum range %2 at %1°</source>
        <translation>Минимальный размах %2 при&#xa0;%1°</translation>
    </message>
    <message>
        <source>Minimum RMS %2 at %1°</source>
        <translation>Минимальное СКЗ %2 при&#xa0;%1°</translation>
    </message>
    <message>
        <source>does not fit</source>
        <translation>нет места</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Цикл</translation>
    </message>
    <message>
        <source>Flywheel</source>
        <translation>Маховик</translation>
    </message>
</context>
<context>
    <name>ravnoves::BalanceShaftPage</name>
    <message>
        <source>Engine</source>
        <translation>Двигатель</translation>
    </message>
    <message>
        <source>ω</source>
        <translation>ω</translation>
    </message>
    <message>
        <source>Angular speed, n π / 30</source>
        <translation>Угловая скорость, n π / 30</translation>
    </message>
    <message>
        <source>Reciprocating masses</source>
        <translation>Поступательные массы</translation>
    </message>
    <message>
        <source>Sum mⱼ</source>
        <translation>Сумма mⱼ</translation>
    </message>
    <message>
        <source>Counterweights and shaft</source>
        <translation>Противовесы и вал</translation>
    </message>
    <message>
        <source>Torque between the rows of its table</source>
        <translation>Момент между строками таблицы</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Данные</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Момент</translation>
    </message>
    <message>
        <source>Shaft angle &amp;α</source>
        <translation>Угол вала &amp;α</translation>
    </message>
    <message>
        <source>Crank angle of the picture; 0 is top dead centre</source>
        <translation>Угол поворота кривошипа на рисунке; 0 — верхняя мёртвая точка</translation>
    </message>
    <message>
        <source>Criteria of the three moments</source>
        <translation>Критерии трёх моментов</translation>
    </message>
    <message>
        <source>Forces, masses and sizes</source>
        <translation>Силы, массы и размеры</translation>
    </message>
    <message>
        <source>&amp;Use the best feasible α</source>
        <translation>Применит&amp;ь лучший допустимый α</translation>
    </message>
    <message>
        <source>Not listed above: %1.</source>
        <translation>Выше не показано: %1.</translation>
    </message>
    <message>
        <source>Sizes for clearance</source>
        <translation>Размеры для зазоров</translation>
    </message>
    <message>
        <source>Apply the α of the minimum &amp;range</source>
        <translation>Применить α минимального &amp;размаха</translation>
    </message>
    <message>
        <source>Apply the α of the minimum R&amp;MS</source>
        <translation>Применить α минимального &amp;СКЗ</translation>
    </message>
    <message>
        <source>Angle from the cylinder axis to the line of centres, in the direction of rotation; at 90° the shaft is beside the crank.</source>
        <translation>Угол от оси цилиндра до линии центров по направлению вращения; при 90° вал сбоку от кривошипа.</translation>
    </message>
    <message>
        <source>Over all feasible α, exact for the continuous cycle</source>
        <translation>По всем допустимым α, точно для непрерывного цикла</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Применить</translation>
    </message>
    <message>
        <source>Shift the trace by &amp;360°</source>
        <translation>Сдвинуть диаграмму на &amp;360°</translation>
    </message>
    <message>
        <source>Reciprocating mass: the sum of the parts.</source>
        <translation>Возвратно-поступательная масса: сумма частей.</translation>
    </message>
    <message>
        <source>Best place on the &amp;map</source>
        <translation>Лучшее место на &amp;карте</translation>
    </message>
</context>
<context>
    <name>ravnoves::BalancingForm</name>
    <message>
        <source>Balance shafts</source>
        <translation>Балансирные валы</translation>
    </message>
    <message>
        <source>&amp;Add shaft</source>
        <translation>До&amp;бавить вал</translation>
    </message>
    <message>
        <source>&amp;Counterweights on the end webs</source>
        <translation>Противовесы на крайних &amp;щеках</translation>
    </message>
    <message>
        <source>Two weights that cancel force and moment of the rotating masses, and a share of the forward part of the first order</source>
        <translation>Два груза, гасящие силу и момент вращающихся масс и долю прямой части первого порядка</translation>
    </message>
    <message>
        <source>Counterweights</source>
        <translation>Противовесы</translation>
    </message>
    <message>
        <source>k order, L distance of the weights (%1), ρ their radius (%1), δ phase error (°)</source>
        <translation>k — порядок, L — расстояние между грузами (%1), ρ — их радиус (%1), δ — ошибка фазы (°)</translation>
    </message>
</context>
<context>
    <name>ravnoves::CaseBudgetModel</name>
    <message>
        <source>cannot be solved</source>
        <translation>не решается</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Значение</translation>
    </message>
    <message>
        <source>Changes by</source>
        <translation>Меняется на</translation>
    </message>
    <message>
        <source>Rounding</source>
        <translation>Округление</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Kinematics: two-term form</source>
        <translation>Кинематика: двучленная форма</translation>
    </message>
    <message>
        <source>Tolerance: %1</source>
        <translation>Допуск: %1</translation>
    </message>
    <message>
        <source>Result and change</source>
        <translation>Результат и изменение</translation>
    </message>
    <message>
        <source>Leading results of the open case; below each, the effect of a single change</source>
        <translation>Главные результаты открытой задачи; под каждым — влияние одного изменения</translation>
    </message>
    <message>
        <source>Present result</source>
        <translation>Текущий результат</translation>
    </message>
    <message>
        <source>Difference from the value, the larger of two</source>
        <translation>Отличие от значения, большее из двух</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Ед.</translation>
    </message>
</context>
<context>
    <name>ravnoves::CaseDocument</name>
    <message>
        <source>%1 is an open case; choose another file.</source>
        <translation>%1 — открытая задача; выберите другой файл.</translation>
    </message>
    <message>
        <source>%1 is a file that an open case reads; choose another file.</source>
        <translation>%1 — файл, который читает открытая задача; выберите другой файл.</translation>
    </message>
</context>
<context>
    <name>ravnoves::CaseProperties</name>
    <message>
        <source>Title and notes</source>
        <translation>Название и заметки</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>&amp;Название</translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation>&amp;Заметки</translation>
    </message>
    <message>
        <source>Title of the case, in its file and in the window</source>
        <translation>Название задачи, в файле и в окне</translation>
    </message>
    <message>
        <source>Your notes on the case: sources, assumptions, open tasks. They are saved with the case.</source>
        <translation>Ваши заметки о задаче: источники, допущения, что осталось сделать. Сохраняются вместе с ней.</translation>
    </message>
</context>
<context>
    <name>ravnoves::CompensationPlot</name>
    <message>
        <source>Excess compensated</source>
        <translation>Компенсируемая масса</translation>
    </message>
    <message>
        <source>Excess compensated over the lightening of one plug</source>
        <translation>Компенсируемая масса от облегчения одной заглушки</translation>
    </message>
    <message>
        <source>lightening of one plug Δm, g</source>
        <translation>облегчение одной заглушки Δm, г</translation>
    </message>
    <message>
        <source>Δmᵤ, g</source>
        <translation>Δmᵤ, г</translation>
    </message>
    <message>
        <source>present %1</source>
        <translation>сейчас %1</translation>
    </message>
</context>
<context>
    <name>ravnoves::CorrectionSheet</name>
    <message>
        <source>Several holes</source>
        <translation>Несколько отверстий</translation>
    </message>
    <message>
        <source>Heavy metal</source>
        <translation>Тяжёлый металл</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Отверстие</translation>
    </message>
    <message>
        <source>Angle, °</source>
        <translation>Угол, °</translation>
    </message>
    <message>
        <source>Drilled before the &amp;last reading: add</source>
        <translation>Было до &amp;последнего показания: добавить</translation>
    </message>
    <message>
        <source>For a hole that was not planned: the last reading contains its effect, the one before does not.</source>
        <translation>Для отверстия, которого не было в плане: последнее показание его учитывает, предыдущее — нет.</translation>
    </message>
    <message>
        <source>Drilled before the first reading: &amp;add</source>
        <translation>Было до первого показания: &amp;добавить</translation>
    </message>
    <message>
        <source>Existing hole</source>
        <translation>Имеющееся отверстие</translation>
    </message>
    <message>
        <source>Available drills</source>
        <translation>Имеющиеся свёрла</translation>
    </message>
    <message>
        <source>Try a hole</source>
        <translation>Проверить отверстие</translation>
    </message>
    <message>
        <source>%1: residual %2 at %3.</source>
        <translation>%1: остаток %2 на %3.</translation>
    </message>
    <message>
        <source>Already drilled: correct holes that differ from the plan</source>
        <translation>Уже просверлено: исправьте отличия от плана</translation>
    </message>
    <message>
        <source>Actual drilling</source>
        <translation>Фактически</translation>
    </message>
    <message>
        <source>The planned values were replaced; Undo restores them.</source>
        <translation>Значения плана заменены; отмена вернёт их.</translation>
    </message>
    <message>
        <source>None yet. The plan appears here after the next run.</source>
        <translation>Пока нет. План появится здесь после следующего пуска.</translation>
    </message>
    <message>
        <source>Enter both ends of the drilling sector.</source>
        <translation>Введите обе границы сектора сверления.</translation>
    </message>
    <message>
        <source>Only for a hole that the first readings contain. New holes keep clear of this hole; it may be deepened.</source>
        <translation>Только для отверстия, которое уже вошло в первые показания. Новые отверстия обходят его; его можно углубить.</translation>
    </message>
</context>
<context>
    <name>ravnoves::CrankViews</name>
    <message>
        <source>Rotating masses and counterweights</source>
        <translation>Вращающиеся массы и противовесы</translation>
    </message>
    <message>
        <source>The crank from the front with crankpin 1 up; angles from crankpin 1, counter-clockwise, lags against the rotation.</source>
        <translation>Вал спереди, шатунная шейка 1 вверху; углы от шейки 1 против часовой стрелки, отставания — против вращения.</translation>
    </message>
    <message>
        <source>front web</source>
        <translation>передняя щека</translation>
    </message>
    <message>
        <source>rear web</source>
        <translation>задняя щека</translation>
    </message>
    <message>
        <source>(switched off)</source>
        <translation>(выключены)</translation>
    </message>
    <message>
        <source>No counterweights: switch them on under Balancing.</source>
        <translation>Противовесов нет: включите их на вкладке «Баланс».</translation>
    </message>
    <message>
        <source>force</source>
        <translation>сила</translation>
    </message>
    <message>
        <source>moment</source>
        <translation>момент</translation>
    </message>
    <message>
        <source>Firing order</source>
        <translation>Порядок работы</translation>
    </message>
    <message>
        <source>No firing order given.</source>
        <translation>Порядок работы не задан.</translation>
    </message>
    <message>
        <source>even, every %1°</source>
        <translation>равномерно, через %1°</translation>
    </message>
    <message>
        <source>uneven, %1° to %2°</source>
        <translation>неравномерно, от %1° до %2°</translation>
    </message>
    <message>
        <source>One cycle of the crank, %1, counter-clockwise from the top: cylinders in the order of firing, the intervals between them, the present crank angle.</source>
        <translation>Один цикл, %1 поворота вала, против часовой стрелки сверху: цилиндры в порядке работы, интервалы между ними, текущий угол поворота.</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>цилиндр</translation>
    </message>
    <message>
        <source>crank angle, °</source>
        <translation>угол поворота вала, °</translation>
    </message>
    <message>
        <source>interval, °</source>
        <translation>интервал, °</translation>
    </message>
    <message>
        <source>Balance shafts: arrangement and phases</source>
        <translation>Балансирные валы: расположение и фазы</translation>
    </message>
    <message>
        <source>on</source>
        <translation>вкл.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>выкл.</translation>
    </message>
    <message>
        <source>nothing to cancel</source>
        <translation>гасить нечего</translation>
    </message>
    <message>
        <source>recip. %1 → %2</source>
        <translation>поступ. %1 → %2</translation>
    </message>
    <message>
        <source>mρ %1</source>
        <translation>mρ %1</translation>
    </message>
    <message>
        <source>m %1</source>
        <translation>m %1</translation>
    </message>
    <message>
        <source>Shafts from the front at the present crank angle; red: cancelled part; dashed: axis and crankpin of cylinder 1.</source>
        <translation>Валы спереди при текущем угле кривошипа; красное: уравновешиваемая часть; штрих: ось и шейка цилиндра 1.</translation>
    </message>
    <message>
        <source>No balance shafts. Press “Add shaft” under Balancing.</source>
        <translation>Балансирных валов нет. Нажмите «Добавить вал» на вкладке «Баланс».</translation>
    </message>
</context>
<context>
    <name>ravnoves::CylinderEditor</name>
    <message>
        <source>Add a cylinder below</source>
        <translation>Добавить цилиндр ниже</translation>
    </message>
    <message>
        <source>Remove the selected cylinders</source>
        <translation>Удалить выбранные цилиндры</translation>
    </message>
    <message>
        <source>E&amp;ven firing</source>
        <translation>Равномерные &amp;вспышки</translation>
    </message>
    <message>
        <source>Cylinders</source>
        <translation>Цилиндры</translation>
    </message>
    <message>
        <source>The cylinders of the layout chosen. Editing one makes this a table of your own; Ctrl+V pastes from a spreadsheet.</source>
        <translation>Цилиндры выбранной компоновки. После правки это ваша собственная таблица; Ctrl+V вставляет из электронной таблицы.</translation>
    </message>
    <message>
        <source>Your own table. Double-click a cell to edit; Ctrl+V pastes from a spreadsheet.</source>
        <translation>Ваша таблица. Двойной щелчок — правка ячейки; Ctrl+V вставляет из электронной таблицы.</translation>
    </message>
    <message>
        <source>A&amp;rticulated rods</source>
        <translation>&amp;Прицепные шатуны</translation>
    </message>
    <message>
        <source>Sets the crankpins for even firing in the firing order. The second bank is shifted by γ + 2 φ_TDC (the paper prints γ + φ_TDC).</source>
        <translation>Ставит шатунные шейки для равномерных вспышек в порядке работы. Второй ряд смещён на γ + 2 φ_ВМТ (в статье напечатано γ + φ_ВМТ).</translation>
    </message>
    <message>
        <source>On a shared crankpin one rod is the master, the others are attached by knuckle pins, as in radials. Off: all rods run on the crankpin.</source>
        <translation>На общей шейке один шатун главный, остальные прицеплены пальцами, как в звёздах. Выключено: все шатуны на шейке.</translation>
    </message>
    <message>
        <source>A knuckle radius makes a rod articulated; blank: the rod runs on the crankpin. Values in italics follow from others.</source>
        <translation>Радиус прицепа делает шатун прицепным; пусто: шатун на шейке. Значения курсивом следуют из других.</translation>
    </message>
</context>
<context>
    <name>ravnoves::CylinderTableModel</name>
    <message>
        <source>Cylinder %1</source>
        <translation>Цилиндр %1</translation>
    </message>
    <message>
        <source>Add cylinder</source>
        <translation>Добавление цилиндра</translation>
    </message>
    <message>
        <source>An engine has at least one cylinder.</source>
        <translation>В двигателе хотя бы один цилиндр.</translation>
    </message>
    <message>
        <source>Remove cylinder</source>
        <translation>Удаление цилиндра</translation>
    </message>
    <message>
        <source>At most %1 cylinders.</source>
        <translation>Не больше %1 цилиндров.</translation>
    </message>
    <message>
        <source>Paste cylinders</source>
        <translation>Вставка цилиндров</translation>
    </message>
    <message>
        <source>stroke, mm</source>
        <translation>ход, мм</translation>
    </message>
    <message>
        <source>TDC, °</source>
        <translation>ВМТ, °</translation>
    </message>
    <message>
        <source>Stroke of the piston; follows from the other values</source>
        <translation>Ход поршня; следует из других значений</translation>
    </message>
    <message>
        <source>Top dead centre: the crank&apos;s angle from the cylinder&apos;s axis; follows from the other values</source>
        <translation>Верхняя мёртвая точка: угол кривошипа от оси цилиндра; следует из других значений</translation>
    </message>
    <message>
        <source>master</source>
        <translation>главный</translation>
    </message>
    <message>
        <source>Top dead centre %1° from its axis, stroke %2</source>
        <translation>Верхняя мёртвая точка в %1° от своей оси, ход %2</translation>
    </message>
</context>
<context>
    <name>ravnoves::Documents</name>
    <message>
        <source>Reload</source>
        <translation>Перечитать</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>Оставить моё</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>Файл %1 изменён другой программой.</translation>
    </message>
    <message>
        <source>Show the present contents of the file. Undo restores this page.</source>
        <translation>Показать текущее содержимое файла. Отмена вернёт эту страницу.</translation>
    </message>
    <message>
        <source>Save this page in another file.</source>
        <translation>Сохранить эту страницу в другой файл.</translation>
    </message>
    <message>
        <source>Continue with this page. Saving replaces the file.</source>
        <translation>Продолжить с этой страницей. При сохранении она заменит файл.</translation>
    </message>
    <message>
        <source>Continue with the numbers read before. The next time, the case opens with the numbers of the file.</source>
        <translation>Продолжить с числами, прочитанными раньше. В следующий раз задача откроется с числами из файла.</translation>
    </message>
    <message>
        <source>%1 was deleted, moved or renamed.</source>
        <translation>Файл %1 удалён, перемещён или переименован.</translation>
    </message>
    <message>
        <source>Open case</source>
        <translation>Открыть задачу</translation>
    </message>
    <message>
        <source>Unsaved cases</source>
        <translation>Несохранённые задачи</translation>
    </message>
    <message>
        <source>Too many files; not opened: %1</source>
        <translation>Слишком много файлов; не открыто: %1</translation>
    </message>
    <message>
        <source>Open cases</source>
        <translation>Открытые задачи</translation>
    </message>
    <message>
        <source>Close (%1)</source>
        <translation>Закрыть (%1)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>&amp;Locate file…</source>
        <translation>&amp;Указать файл…</translation>
    </message>
    <message>
        <source>Where is %1?</source>
        <translation>Где %1?</translation>
    </message>
    <message>
        <source>The file selected for %1 is not suitable.</source>
        <translation>Файл, выбранный вместо %1, не подходит.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Несохранённые изменения</translation>
    </message>
    <message>
        <source>Save the changes of “%1”?</source>
        <translation>Сохранить изменения в «%1»?</translation>
    </message>
    <message>
        <source>Do&amp;n’t save</source>
        <translation>&amp;Не сохранять</translation>
    </message>
    <message>
        <source>Save case</source>
        <translation>Сохранить задачу</translation>
    </message>
    <message>
        <source>Ravnoves case</source>
        <translation>Задача Ravnoves</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Сохранить как…</translation>
    </message>
    <message>
        <source>%1 was changed by another program since it was opened or saved here. Overwrite it?</source>
        <translation>Файл %1 изменён другой программой с тех пор, как был открыт или сохранён здесь. Записать поверх?</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>&amp;Записать поверх</translation>
    </message>
    <message>
        <source>Close case</source>
        <translation>Закрыть задачу</translation>
    </message>
    <message>
        <source>%1 is open in another tab. Close that tab first, or choose another name.</source>
        <translation>Файл %1 открыт на другой вкладке. Сначала закройте её или выберите другое имя.</translation>
    </message>
</context>
<context>
    <name>ravnoves::EditableTable</name>
    <message>
        <source>Also not accepted: %1</source>
        <translation>Также не принято: %1</translation>
    </message>
    <message>
        <source>Not pasted: the block has %1 columns, but only %2 fit here.</source>
        <translation>Не вставлено: в блоке столбцов %1, а помещается %2.</translation>
    </message>
    <message>
        <source>Not pasted: the block has %1 rows, but only %2 fit here.</source>
        <translation>Не вставлено: в блоке строк %1, а помещается %2.</translation>
    </message>
</context>
<context>
    <name>ravnoves::ElasticHingeModel</name>
    <message>
        <source>None: %1.</source>
        <translation>Нет: %1.</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Величина</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Значение</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Ед.</translation>
    </message>
    <message>
        <source>Relief (%1)</source>
        <translation>Перепад (%1)</translation>
    </message>
    <message>
        <source>Spring travel</source>
        <translation>Ход пружины</translation>
    </message>
    <message>
        <source>any</source>
        <translation>любой</translation>
    </message>
    <message>
        <source>∮ M₁₂ dφ</source>
        <translation>∮ M₁₂ dφ</translation>
    </message>
    <message>
        <source>J</source>
        <translation>Дж</translation>
    </message>
    <message>
        <source>Side force, no hinge</source>
        <translation>Бок. сила без шарнира</translation>
    </message>
    <message>
        <source>Side force, rod hinge</source>
        <translation>Бок. сила с шарниром</translation>
    </message>
    <message>
        <source>Counterweight P₄</source>
        <translation>Противовес P₄</translation>
    </message>
    <message>
        <source>reverses</source>
        <translation>реверс</translation>
    </message>
    <message>
        <source>Ripple without hinge</source>
        <translation>Неравном. без шарнира</translation>
    </message>
    <message>
        <source>Ripple with hinge</source>
        <translation>Неравном. с шарниром</translation>
    </message>
    <message>
        <source>without hinge</source>
        <translation>без шарнира</translation>
    </message>
    <message>
        <source>crank hinge</source>
        <translation>шарнир кривошипа</translation>
    </message>
    <message>
        <source>both hinges</source>
        <translation>оба шарнира</translation>
    </message>
    <message>
        <source>(ω_max − ω_min) / mean ω of the free motion, %</source>
        <translation>(ω_max − ω_min) к средней ω свободного движения, %</translation>
    </message>
    <message>
        <source>Moment error, %1</source>
        <translation>Погр. момента, %1</translation>
    </message>
    <message>
        <source>Ripple from %1</source>
        <translation>Неравн. от %1</translation>
    </message>
    <message>
        <source>%1: %2…%3, drift %4</source>
        <translation>%1: %2…%3, уход %4</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>от %1</translation>
    </message>
    <message>
        <source>c = %1, ρ₀ = %2: relief %3 within %4. Spring: minimum length %5, maximum force %6, maximum energy %7 J.</source>
        <translation>c = %1, ρ₀ = %2: перепад %3 в пределах %4. Пружина: минимальная длина %5, максимальная сила %6, максимальная энергия %7 Дж.</translation>
    </message>
    <message>
        <source>Use the guide found</source>
        <translation>Применена найденная направляющая</translation>
    </message>
    <message>
        <source>Minimum preload of the guide</source>
        <translation>Минимальный преднатяг</translation>
    </message>
    <message>
        <source>Maximum minus minimum radius of the guide</source>
        <translation>Максимальный радиус направляющей минус минимальный</translation>
    </message>
    <message>
        <source>Preload min / present</source>
        <translation>Преднатяг мин. / есть</translation>
    </message>
    <message>
        <source>|ℓ₀/2 − ρ₀|: minimum to store the energy, and present value</source>
        <translation>|ℓ₀/2 − ρ₀|: минимум, чтобы запасти энергию, и текущее значение</translation>
    </message>
    <message>
        <source>Maximum minus minimum length of the spring over a turn</source>
        <translation>Максимальная длина пружины за оборот минус минимальная</translation>
    </message>
    <message>
        <source>Maximum spring force</source>
        <translation>Сила пружины, макс.</translation>
    </message>
    <message>
        <source>c |ℓ − ℓ₀|, maximum over a turn</source>
        <translation>c |ℓ − ℓ₀|, максимум за оборот</translation>
    </message>
    <message>
        <source>Maximum error of the hinge&apos;s moment at this profile error; in brackets relative to the maximum moment</source>
        <translation>Максимальная погрешность момента шарнира при этой погрешности профиля; в скобках — к максимальному моменту</translation>
    </message>
    <message>
        <source>Radius of curvature of the guide; a cutter must be smaller</source>
        <translation>Радиус кривизны направляющей; фреза должна быть меньше</translation>
    </message>
    <message>
        <source>Maximum roller radius</source>
        <translation>Радиус ролика, макс.</translation>
    </message>
    <message>
        <source>Maximum radius of a roller that touches the whole guide</source>
        <translation>Максимальный радиус ролика, который касается всей направляющей</translation>
    </message>
    <message>
        <source>Work of the rod hinge&apos;s moment over a turn; 0 if a spring can supply it</source>
        <translation>Работа момента шарнира шатуна за оборот; 0, если её может дать пружина</translation>
    </message>
    <message>
        <source>Maximum force of the slider on its guide</source>
        <translation>Максимальная сила ползуна на направляющую</translation>
    </message>
    <message>
        <source>Maximum force with the rod hinge; in brackets the reduction factor</source>
        <translation>Максимальная сила с шарниром шатуна; в скобках — кратность снижения</translation>
    </message>
    <message>
        <source>Weight on the rod for ∮ M₁₂ dφ = 0, or as entered</source>
        <translation>Вес груза на шатуне при ∮ M₁₂ dφ = 0 или заданный</translation>
    </message>
    <message>
        <source>(ω_max − ω_min) / mean ω with the crank hinge, %</source>
        <translation>(ω_max − ω_min) к средней ω с шарниром кривошипа, %</translation>
    </message>
    <message>
        <source>(ω_max − ω_min) / mean ω after a start away from the design speed</source>
        <translation>(ω_max − ω_min) к средней ω после пуска с нерасчётной скорости</translation>
    </message>
    <message>
        <source>The present design meets the requirements: relief %1, maximum force %2, moment error %3.</source>
        <translation>Текущая конструкция отвечает требованиям: перепад %1, максимальная сила %2, погрешность момента %3.</translation>
    </message>
    <message>
        <source>Present design: relief %1, maximum force %2, moment error %3.</source>
        <translation>Текущая конструкция: перепад %1, максимальная сила %2, погрешность момента %3.</translation>
    </message>
    <message>
        <source>Min. curvature radius</source>
        <translation>Радиус кривизны, мин.</translation>
    </message>
</context>
<context>
    <name>ravnoves::ElasticHingePage</name>
    <message>
        <source>Play the computed motion in slow motion</source>
        <translation>Показать рассчитанное движение замедленно</translation>
    </message>
    <message>
        <source>&amp;ω</source>
        <translation>&amp;ω</translation>
    </message>
    <message>
        <source>&amp;λ</source>
        <translation>&amp;λ</translation>
    </message>
    <message>
        <source>&amp;c</source>
        <translation>&amp;c</translation>
    </message>
    <message>
        <source>&amp;ρ₀</source>
        <translation>&amp;ρ₀</translation>
    </message>
    <message>
        <source>ℓ&amp;₂</source>
        <translation>ℓ&amp;₂</translation>
    </message>
    <message>
        <source>&amp;error</source>
        <translation>по&amp;гр.</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Данные</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Подбор</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Чертёж</translation>
    </message>
    <message>
        <source>without hinge</source>
        <translation>без шарнира</translation>
    </message>
    <message>
        <source>crank hinge</source>
        <translation>у кривошипа</translation>
    </message>
    <message>
        <source>both hinges</source>
        <translation>оба шарнира</translation>
    </message>
    <message>
        <source>off design</source>
        <translation>вне расчёта</translation>
    </message>
    <message>
        <source>Crank angle of the picture, counter-clockwise from the slider line</source>
        <translation>Угол кривошипа на рисунке, против часовой стрелки от линии ползуна</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>&amp;Движение</translation>
    </message>
    <message>
        <source>Use this pre&amp;load</source>
        <translation>Применить &amp;этот преднатяг</translation>
    </message>
    <message>
        <source>Motion shown</source>
        <translation>Показанное движение</translation>
    </message>
    <message>
        <source>Computed motion that the picture shows</source>
        <translation>Рассчитанное движение на рисунке</translation>
    </message>
    <message>
        <source>Results of the design</source>
        <translation>Результаты расчёта</translation>
    </message>
</context>
<context>
    <name>ravnoves::EngineForm</name>
    <message>
        <source>Layout</source>
        <translation>Схема двигателя</translation>
    </message>
    <message>
        <source>Crank gear</source>
        <translation>Кривошипно-шатунный механизм</translation>
    </message>
    <message>
        <source>φ at TDC, cylinder 1</source>
        <translation>φ в ВМТ, цилиндр 1</translation>
    </message>
    <message>
        <source>No effect: no throw of this layout has cylinders of two banks.</source>
        <translation>Не действует: в этой схеме ни на одном колене нет цилиндров двух рядов.</translation>
    </message>
    <message>
        <source>Top dead centre: arcsin(λK/(1 + λ)), from the cylinder&apos;s axis on the side of its offset. Volkswagen VR5: 3°20′.</source>
        <translation>Верхняя мёртвая точка: arcsin(λK/(1 + λ)), от оси цилиндра в сторону её смещения. Volkswagen VR5: 3°20′.</translation>
    </message>
    <message>
        <source>Cylinder la&amp;yout</source>
        <translation>&amp;Компоновка</translation>
    </message>
    <message>
        <source>A layout of the library, the paper&apos;s engine, or your own table</source>
        <translation>Компоновка из списка, двигатель статьи или ваша таблица</translation>
    </message>
    <message>
        <source>&amp;Rod as a rigid body</source>
        <translation>Шатун — &amp;твёрдое тело</translation>
    </message>
    <message>
        <source>Rigid rod</source>
        <translation>Шатун — твёрдое тело</translation>
    </message>
    <message>
        <source>of one cylinder</source>
        <translation>одного цилиндра</translation>
    </message>
    <message>
        <source>of one throw</source>
        <translation>одного колена</translation>
    </message>
    <message>
        <source>On each throw</source>
        <translation>На каждом колене</translation>
    </message>
    <message>
        <source>At the crank radius, with the share of rigid rods</source>
        <translation>На радиусе кривошипа, с долей твёрдых шатунов</translation>
    </message>
    <message>
        <source>Mass given</source>
        <translation>Задана масса</translation>
    </message>
    <message>
        <source>Enter the mass of one cylinder or of one throw; a throw with two rods carries the mass of one cylinder twice.</source>
        <translation>Введите массу одного цилиндра или одного колена; колено с двумя шатунами несёт массу цилиндра дважды.</translation>
    </message>
    <message>
        <source>Off: the rod&apos;s shares are in the masses above. On: enter its mass, centre and inertia; they act on roll moment and torque too.</source>
        <translation>Выкл.: доли шатуна входят в массы выше. Вкл.: введите массу, центр и момент инерции; они действуют и на опрокидывающий и крутящий моменты.</translation>
    </message>
</context>
<context>
    <name>ravnoves::EngineView</name>
    <message>
        <source>Engine from the front and the crank from the side</source>
        <translation>Двигатель спереди и коленчатый вал сбоку</translation>
    </message>
    <message>
        <source>φ = %1°</source>
        <translation>φ = %1°</translation>
    </message>
    <message>
        <source>To scale; the crank turns counter-clockwise. Drag to turn the crank; Space plays and pauses, arrow keys step.</source>
        <translation>В масштабе; вал вращается против часовой стрелки. Поворачивается мышью, пробел — пуск и пауза, стрелки — по шагу.</translation>
    </message>
</context>
<context>
    <name>ravnoves::EntryField</name>
    <message>
        <source>Cut: at most %1 characters.</source>
        <translation>Обрезано: не больше %1 знаков.</translation>
    </message>
    <message>
        <source>Not accepted before other values changed; press Enter to try again: %1</source>
        <translation>Не принято до изменения других значений; Enter проверит снова: %1</translation>
    </message>
</context>
<context>
    <name>ravnoves::Fields</name>
    <message>
        <source>Empty: %1.</source>
        <translation>Пусто: %1.</translation>
    </message>
</context>
<context>
    <name>ravnoves::FigureMenu</name>
    <message>
        <source>Copy data</source>
        <translation>Копировать данные</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Копировать рисунок</translation>
    </message>
    <message>
        <source>Save picture or data…</source>
        <translation>Сохранить рисунок или данные…</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Сохранить рисунок…</translation>
    </message>
    <message>
        <source>Save picture or data</source>
        <translation>Сохранить рисунок или данные</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Сохранить рисунок</translation>
    </message>
</context>
<context>
    <name>ravnoves::FileDialogs</name>
    <message>
        <source>Table, CSV</source>
        <translation>Таблица, CSV</translation>
    </message>
    <message>
        <source>Drawing, DXF</source>
        <translation>Чертёж, DXF</translation>
    </message>
    <message>
        <source>PDF</source>
        <translation>PDF</translation>
    </message>
    <message>
        <source>Picture, PNG</source>
        <translation>Рисунок, PNG</translation>
    </message>
    <message>
        <source>Drawing, SVG</source>
        <translation>Векторный рисунок, SVG</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt *.tsv);;All files (*)</source>
        <translation>Таблицы (*.csv *.txt *.tsv);;Все файлы (*)</translation>
    </message>
    <message>
        <source>“%1” cannot be written as .%2. Possible: %3.</source>
        <translation>«%1» нельзя записать как .%2. Возможно: %3.</translation>
    </message>
    <message>
        <source>“%1” already exists. Replace it?</source>
        <translation>«%1» уже есть. Заменить?</translation>
    </message>
</context>
<context>
    <name>ravnoves::ForcePlot</name>
    <message>
        <source>First-order force</source>
        <translation>Сила первого порядка</translation>
    </message>
    <message>
        <source>First-order force of the cylinders on a bob weight, over a turn</source>
        <translation>Сила первого порядка цилиндров одного груза за оборот</translation>
    </message>
    <message>
        <source>vertical, %1</source>
        <translation>по вертикали, %1</translation>
    </message>
    <message>
        <source>without counterweights</source>
        <translation>без противовесов</translation>
    </message>
    <message>
        <source>horizontal, %1</source>
        <translation>по горизонтали, %1</translation>
    </message>
    <message>
        <source>with counterweights</source>
        <translation>с противовесами</translation>
    </message>
    <message>
        <source>Reciprocating parts only, as a mass at the crank radius</source>
        <translation>Только возвратно-поступательные части, как масса на радиусе кривошипа</translation>
    </message>
    <message>
        <source>Residual with counterweights for this bob weight</source>
        <translation>Остаток с противовесами под этот груз</translation>
    </message>
</context>
<context>
    <name>ravnoves::Form</name>
    <message>
        <source>At most %1 characters.</source>
        <translation>Не больше %1 знаков.</translation>
    </message>
</context>
<context>
    <name>ravnoves::GuideExportForm</name>
    <message>
        <source>Guide for the machine shop</source>
        <translation>Направляющая для цеха</translation>
    </message>
    <message>
        <source>&amp;Hinge</source>
        <translation>&amp;Шарнир</translation>
    </message>
    <message>
        <source>compressed</source>
        <translation>сжата</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>растянута</translation>
    </message>
    <message>
        <source>S&amp;pring</source>
        <translation>Пру&amp;жина</translation>
    </message>
    <message>
        <source>guide turns</source>
        <translation>направляющая</translation>
    </message>
    <message>
        <source>spring turns</source>
        <translation>пружина</translation>
    </message>
    <message>
        <source>&amp;What turns</source>
        <translation>&amp;Что вращается</translation>
    </message>
    <message>
        <source>Write D&amp;XF…</source>
        <translation>Записать D&amp;XF…</translation>
    </message>
    <message>
        <source>Closed polylines in mm, 1:1: layers PROFILE, ROLLER_PATH, AXIS, NOTE</source>
        <translation>Замкнутые ломаные в мм, 1:1: слои PROFILE, ROLLER_PATH, AXIS, NOTE</translation>
    </message>
    <message>
        <source>Write &amp;CSV…</source>
        <translation>Записать &amp;CSV…</translation>
    </message>
    <message>
        <source>Crank angle, polar angle, radius, x and y of path and profile; °, mm</source>
        <translation>Угол кривошипа, полярный угол, радиус, x и y пути и профиля; °, мм</translation>
    </message>
    <message>
        <source>The roller undercuts this guide.</source>
        <translation>Ролик подрезает эту направляющую.</translation>
    </message>
    <message>
        <source>The profile is offset from the path of the roller&apos;s centre by the roller&apos;s radius.</source>
        <translation>Профиль отстоит от пути центра ролика на радиус ролика.</translation>
    </message>
    <message>
        <source>Export guide</source>
        <translation>Запись направляющей</translation>
    </message>
    <message>
        <source>%1 written</source>
        <translation>Записано: %1</translation>
    </message>
    <message>
        <source>Hinge whose guide is written</source>
        <translation>Шарнир, направляющая которого записывается</translation>
    </message>
    <message>
        <source>Spring compressed or stretched</source>
        <translation>Пружина сжата или растянута</translation>
    </message>
    <message>
        <source>In the paper the guide turns with the crank and the spring is fixed: the drawing is the mirror image of the plot</source>
        <translation>В статье направляющая вращается с кривошипом, а пружина неподвижна: чертёж зеркален графику</translation>
    </message>
    <message>
        <source>This guide has no such branch.</source>
        <translation>У этой направляющей нет такой ветви.</translation>
    </message>
    <message>
        <source>No guide: %1.</source>
        <translation>Направляющей нет: %1.</translation>
    </message>
</context>
<context>
    <name>ravnoves::GuideSearchForm</name>
    <message>
        <source>Found</source>
        <translation>Найдено</translation>
    </message>
    <message>
        <source>Sets c and ρ₀ to the values found</source>
        <translation>Задаёт найденные c и ρ₀</translation>
    </message>
    <message>
        <source>Use &amp;these values</source>
        <translation>Применит&amp;ь найденное</translation>
    </message>
    <message>
        <source>Required</source>
        <translation>Требуется</translation>
    </message>
    <message>
        <source>Finds stiffness and preload of minimum spring energy for the required relief of the crank&apos;s guide; free length, roller and side of the spring are kept.</source>
        <translation>Находит жёсткость и преднатяг с минимальной энергией пружины для требуемого перепада направляющей кривошипа; свободная длина, ролик и сторона пружины сохраняются.</translation>
    </message>
</context>
<context>
    <name>ravnoves::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Справка</translation>
    </message>
    <message>
        <source>There is no help on this page yet.</source>
        <translation>Справки по этой странице ещё нет.</translation>
    </message>
    <message>
        <source>Search in the help</source>
        <translation>Поиск в справке</translation>
    </message>
    <message>
        <source>Pages of the help</source>
        <translation>Страницы справки</translation>
    </message>
    <message>
        <source>nothing found</source>
        <translation>ничего не найдено</translation>
    </message>
    <message>
        <source>Search this page (Ctrl+F, F3)</source>
        <translation>Искать на этой странице (Ctrl+F, F3)</translation>
    </message>
</context>
<context>
    <name>ravnoves::HingeInputs</name>
    <message>
        <source>Mechanism</source>
        <translation>Механизм</translation>
    </message>
    <message>
        <source>weights, N</source>
        <translation>веса, Н</translation>
    </message>
    <message>
        <source>masses, kg</source>
        <translation>массы, кг</translation>
    </message>
    <message>
        <source>Weights or masses</source>
        <translation>Веса или массы</translation>
    </message>
    <message>
        <source>Springs and guides</source>
        <translation>Пружины и направляющие</translation>
    </message>
    <message>
        <source>Counterweight on the rod</source>
        <translation>Противовес на шатуне</translation>
    </message>
    <message>
        <source>Making the guide</source>
        <translation>Изготовление направляющей</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Движение</translation>
    </message>
</context>
<context>
    <name>ravnoves::HingeMechanismView</name>
    <message>
        <source>Picture of the mechanism with its hinges</source>
        <translation>Рисунок механизма с шарнирами</translation>
    </message>
    <message>
        <source>φ = %1°</source>
        <translation>φ = %1°</translation>
    </message>
    <message>
        <source>crank&apos;s guide, to scale</source>
        <translation>направляющая кривошипа, в масштабе</translation>
    </message>
    <message>
        <source>relief × %1</source>
        <translation>перепад × %1</translation>
    </message>
    <message>
        <source>%1 times slower</source>
        <translation>замедление × %1</translation>
    </message>
    <message>
        <source>ω = %1</source>
        <translation>ω = %1</translation>
    </message>
    <message>
        <source>The mechanism to scale, with the guide&apos;s relief enlarged. Drag to turn the crank; Space plays the computed motion.</source>
        <translation>Механизм в масштабе, перепад направляющей увеличен. Мышью поворачивается кривошип; пробел показывает рассчитанное движение.</translation>
    </message>
</context>
<context>
    <name>ravnoves::HingePlots</name>
    <message>
        <source>φ, °</source>
        <translation>φ, °</translation>
    </message>
    <message>
        <source>x, mm</source>
        <translation>x, мм</translation>
    </message>
    <message>
        <source>y, mm</source>
        <translation>y, мм</translation>
    </message>
    <message>
        <source>ρ₀</source>
        <translation>ρ₀</translation>
    </message>
    <message>
        <source>ℓ₀ − ρ₀</source>
        <translation>ℓ₀ − ρ₀</translation>
    </message>
    <message>
        <source>compressed</source>
        <translation>сжата</translation>
    </message>
    <message>
        <source>Guide of the compressed spring, minus in (3)</source>
        <translation>Направляющая сжатой пружины, минус в (3)</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>растянута</translation>
    </message>
    <message>
        <source>Guide of the stretched spring, plus in (3)</source>
        <translation>Направляющая растянутой пружины, плюс в (3)</translation>
    </message>
    <message>
        <source>ρ over the turn, from its value at 0°</source>
        <translation>ρ за оборот, от значения при 0°</translation>
    </message>
    <message>
        <source>M₁₂ and its potential part</source>
        <translation>M₁₂ и его потенциальная часть</translation>
    </message>
    <message>
        <source>N·m</source>
        <translation>Н·м</translation>
    </message>
    <message>
        <source>Moment on the rod that makes the side force zero, (4), with a counterweight (9)</source>
        <translation>Момент на шатуне, при котором боковая сила равна нулю, (4), с противовесом (9)</translation>
    </message>
    <message>
        <source>potential part</source>
        <translation>потенциальная часть</translation>
    </message>
    <message>
        <source>series</source>
        <translation>ряд</translation>
    </message>
    <message>
        <source>M₁₂ by the other kinematics, for comparison</source>
        <translation>M₁₂ по другой кинематике, для сравнения</translation>
    </message>
    <message>
        <source>M₁₂ at several ω</source>
        <translation>M₁₂ при нескольких ω</translation>
    </message>
    <message>
        <source>Side force with rod hinge, several λ</source>
        <translation>Боковая сила с шарниром шатуна, несколько λ</translation>
    </message>
    <message>
        <source>N</source>
        <translation>Н</translation>
    </message>
    <message>
        <source>Side force without hinge, several ω</source>
        <translation>Боковая сила без шарнира, несколько ω</translation>
    </message>
    <message>
        <source>10 × with hinge</source>
        <translation>10 × с шарниром</translation>
    </message>
    <message>
        <source>Ten times the side force with the rod&apos;s hinge: the same at every ω</source>
        <translation>Десятикратная боковая сила с шарниром шатуна: одна и та же при любой ω</translation>
    </message>
    <message>
        <source>Moment that keeps the crank&apos;s speed</source>
        <translation>Момент, сохраняющий скорость кривошипа</translation>
    </message>
    <message>
        <source>Without the rod&apos;s hinge, d(T + V)/dφ</source>
        <translation>Без шарнира шатуна, d(T + V)/dφ</translation>
    </message>
    <message>
        <source>With the rod&apos;s hinge, M + M₁₂ (1 + ψ′), (8); with a counterweight M₁*, (11)</source>
        <translation>С шарниром шатуна, M + M₁₂ (1 + ψ′), (8); с противовесом M₁*, (11)</translation>
    </message>
    <message>
        <source>M₁ at several ω</source>
        <translation>M₁ при нескольких ω</translation>
    </message>
    <message>
        <source>Crank speed</source>
        <translation>Угловая скорость кривошипа</translation>
    </message>
    <message>
        <source>turns</source>
        <translation>обороты</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>рад/с</translation>
    </message>
    <message>
        <source>without hinge</source>
        <translation>без шарнира</translation>
    </message>
    <message>
        <source>The bare mechanism, from the design speed</source>
        <translation>Механизм без шарниров, с расчётной скорости</translation>
    </message>
    <message>
        <source>crank hinge</source>
        <translation>шарнир кривошипа</translation>
    </message>
    <message>
        <source>With the crank&apos;s hinge, from the design speed</source>
        <translation>С шарниром кривошипа, с расчётной скорости</translation>
    </message>
    <message>
        <source>both hinges</source>
        <translation>оба шарнира</translation>
    </message>
    <message>
        <source>off design</source>
        <translation>вне расчёта</translation>
    </message>
    <message>
        <source>Guides (%1), to scale</source>
        <translation>Направляющие (%1), в масштабе</translation>
    </message>
    <message>
        <source>Guides (%1), relief × %2</source>
        <translation>Направляющие (%1), перепад × %2</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>профиль</translation>
    </message>
    <message>
        <source>ρ − ρ(0), µm</source>
        <translation>ρ − ρ(0), мкм</translation>
    </message>
    <message>
        <source>ρ − ρ(0), mm</source>
        <translation>ρ − ρ(0), мм</translation>
    </message>
    <message>
        <source>no guide</source>
        <translation>нет направляющей</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>точно</translation>
    </message>
    <message>
        <source>M₁* at several ω</source>
        <translation>M₁* при нескольких ω</translation>
    </message>
    <message>
        <source>this case</source>
        <translation>эта задача</translation>
    </message>
    <message>
        <source>At the λ and ω of the case</source>
        <translation>При λ и ω задачи</translation>
    </message>
    <message>
        <source>Profile for the roller: path of its centre, offset by its radius</source>
        <translation>Профиль под ролик: путь его центра, смещённый на радиус</translation>
    </message>
    <message>
        <source>M₁₂ minus its mean, (5)</source>
        <translation>M₁₂ минус его среднее, (5)</translation>
    </message>
    <message>
        <source>With both hinges, from the design speed</source>
        <translation>С обоими шарнирами, с расчётной скорости</translation>
    </message>
    <message>
        <source>With the crank&apos;s hinge, away from the design speed</source>
        <translation>С шарниром кривошипа, вне расчётной скорости</translation>
    </message>
    <message>
        <source>moment on rod (M₁₂)</source>
        <translation>момент на шатуне (M₁₂)</translation>
    </message>
    <message>
        <source>without hinge (M)</source>
        <translation>без шарнира (M)</translation>
    </message>
    <message>
        <source>with hinge (M₁*)</source>
        <translation>с шарниром (M₁*)</translation>
    </message>
    <message>
        <source>with hinge (M₁)</source>
        <translation>с шарниром (M₁)</translation>
    </message>
</context>
<context>
    <name>ravnoves::HingeTabs</name>
    <message>
        <source>R&amp;od hinge</source>
        <translation>Шату&amp;н</translation>
    </message>
    <message>
        <source>Sid&amp;e force</source>
        <translation>Бо&amp;ковая сила</translation>
    </message>
    <message>
        <source>Crank &amp;moment</source>
        <translation>&amp;Момент</translation>
    </message>
    <message>
        <source>&amp;Guides</source>
        <translation>&amp;Направляющие</translation>
    </message>
    <message>
        <source>Guide shown</source>
        <translation>Показанная направляющая</translation>
    </message>
    <message>
        <source>Hinge between frame and crank alone (M), or with the rod&apos;s hinge (M₁), or hinge between crank and rod, over θ = φ + ψ</source>
        <translation>Шарнир между стойкой и кривошипом один (M) или с шарниром шатуна (M₁), либо шарнир между кривошипом и шатуном, по θ = φ + ψ</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>&amp;Направляющая</translation>
    </message>
    <message>
        <source>&amp;Relief ×</source>
        <translation>Перепа&amp;д ×</translation>
    </message>
    <message>
        <source>Enlargement of the guide&apos;s relief; 1 is to scale</source>
        <translation>Увеличение перепада направляющей; 1 — в масштабе</translation>
    </message>
    <message>
        <source>a&amp;uto</source>
        <translation>а&amp;вто</translation>
    </message>
    <message>
        <source>Choose the factor by the relief</source>
        <translation>Выбрать увеличение по перепаду</translation>
    </message>
    <message>
        <source>Mo&amp;tion</source>
        <translation>&amp;Движение</translation>
    </message>
    <message>
        <source>Progress of the motion</source>
        <translation>Ход расчёта движения</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>Stop computing the motion</source>
        <translation>Прекратить расчёт движения</translation>
    </message>
</context>
<context>
    <name>ravnoves::ImportDialog</name>
    <message>
        <source>First lines of the file</source>
        <translation>Первые строки файла</translation>
    </message>
    <message>
        <source>Add this shift to the crank angles of the trace.</source>
        <translation>Прибавить этот сдвиг к углам диаграммы.</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>Чтение файла</translation>
    </message>
    <message>
        <source>I&amp;mport</source>
        <translation>Импор&amp;т</translation>
    </message>
    <message>
        <source>choose</source>
        <translation>выберите</translation>
    </message>
    <message>
        <source>&amp;Separator</source>
        <translation>&amp;Разделитель</translation>
    </message>
    <message>
        <source>Character between the columns.</source>
        <translation>Знак между столбцами.</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>точка с запятой</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>запятая</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>табуляция</translation>
    </message>
    <message>
        <source>blanks</source>
        <translation>пробелы</translation>
    </message>
    <message>
        <source>&amp;Decimal sign</source>
        <translation>Десятичный &amp;знак</translation>
    </message>
    <message>
        <source>Decimal sign of the numbers.</source>
        <translation>Десятичный знак чисел.</translation>
    </message>
    <message>
        <source>point</source>
        <translation>точка</translation>
    </message>
    <message>
        <source>&amp;Header lines</source>
        <translation>Строки за&amp;головка</translation>
    </message>
    <message>
        <source>C&amp;ycle</source>
        <translation>&amp;Цикл</translation>
    </message>
    <message>
        <source>Length of a cycle. Several cycles in the file are averaged.</source>
        <translation>Длина цикла. Несколько циклов в файле усредняются.</translation>
    </message>
    <message>
        <source>360° (two-stroke)</source>
        <translation>360° (двухтактный)</translation>
    </message>
    <message>
        <source>720° (four-stroke)</source>
        <translation>720° (четырёхтактный)</translation>
    </message>
    <message>
        <source>Crank &amp;angle</source>
        <translation>&amp;Угол поворота</translation>
    </message>
    <message>
        <source>Column of the crank angle. Without one, the rows are equal steps over one cycle.</source>
        <translation>Столбец угла поворота коленчатого вала. Без него строки — равные шаги одного цикла.</translation>
    </message>
    <message>
        <source>Angles i&amp;n</source>
        <translation>Единица уг&amp;ла</translation>
    </message>
    <message>
        <source>Unit of the crank angle.</source>
        <translation>Единица угла поворота.</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>градусы</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>радианы</translation>
    </message>
    <message>
        <source>&amp;Pressure</source>
        <translation>&amp;Давление</translation>
    </message>
    <message>
        <source>&amp;Torque</source>
        <translation>&amp;Момент</translation>
    </message>
    <message>
        <source>Column of the cylinder pressure.</source>
        <translation>Столбец давления в цилиндре.</translation>
    </message>
    <message>
        <source>Column of the engine torque.</source>
        <translation>Столбец крутящего момента двигателя.</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>&amp;Единица</translation>
    </message>
    <message>
        <source>Unit of the pressure.</source>
        <translation>Единица давления.</translation>
    </message>
    <message>
        <source>Unit of the torque.</source>
        <translation>Единица момента.</translation>
    </message>
    <message>
        <source>Pr&amp;essure is</source>
        <translation>&amp;Вид давления</translation>
    </message>
    <message>
        <source>Gauge pressure is relative to the atmosphere: 1.01325 bar is added.</source>
        <translation>Избыточное давление отсчитано от атмосферного: прибавляется 1,01325 бар.</translation>
    </message>
    <message>
        <source>absolute</source>
        <translation>абсолютное</translation>
    </message>
    <message>
        <source>gauge</source>
        <translation>избыточное</translation>
    </message>
    <message>
        <source>crank angle</source>
        <translation>угол поворота</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>давление</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>момент</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>столбец %1</translation>
    </message>
    <message>
        <source>none: equal steps</source>
        <translation>нет: равные шаги</translation>
    </message>
    <message>
        <source>Save the cycle</source>
        <translation>Сохранить цикл</translation>
    </message>
    <message>
        <source>from the file</source>
        <translation>по файлу</translation>
    </message>
    <message>
        <source>Lines above the first row, without empty lines and comments (#).</source>
        <translation>Строки над первой строкой чисел, без пустых строк и примечаний (#).</translation>
    </message>
</context>
<context>
    <name>ravnoves::ImportModel</name>
    <message>
        <source>Dead centre: shift by %1° ± %2° (from the compression line)</source>
        <translation>Мёртвая точка: сдвиг на %1° ± %2° (по линии сжатия)</translation>
    </message>
    <message>
        <source>Dead centre, uncertain: shift by %1° ± %2° (from the compression line)</source>
        <translation>Мёртвая точка, ненадёжно: сдвиг на %1° ± %2° (по линии сжатия)</translation>
    </message>
    <message>
        <source>The case file cannot contain these settings: the cycle is saved as a separate CSV file.</source>
        <translation>Файл задачи не может хранить эти настройки: цикл сохраняется отдельным файлом CSV.</translation>
    </message>
    <message>
        <source>The file covers 360°, but the engine of the case is a four-stroke (720°). Import the whole cycle, or choose the cycle of 360° to make the engine a two-stroke.</source>
        <translation>Файл охватывает 360°, а двигатель задачи — четырёхтактный (720°). Импортируйте весь цикл или выберите цикл 360°, и двигатель станет двухтактным.</translation>
    </message>
    <message>
        <source>The file covers 720°, but the engine of the case is a two-stroke (360°). Choose the cycle: 720° makes the engine a four-stroke.</source>
        <translation>Файл охватывает 720°, а двигатель задачи — двухтактный (360°). Выберите цикл: с циклом 720° двигатель станет четырёхтактным.</translation>
    </message>
</context>
<context>
    <name>ravnoves::InertiaMomentsCharts</name>
    <message>
        <source>Shafts</source>
        <translation>Валы</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Грузы</translation>
    </message>
    <message>
        <source>Firing</source>
        <translation>Вспышки</translation>
    </message>
    <message>
        <source>%1, with rotating masses</source>
        <translation>%1, с вращающимися массами</translation>
    </message>
    <message>
        <source>Order 1</source>
        <translation>1-й порядок</translation>
    </message>
    <message>
        <source>Order 2</source>
        <translation>2-й порядок</translation>
    </message>
    <message>
        <source>φ, °</source>
        <translation>φ, °</translation>
    </message>
    <message>
        <source>M, N·m</source>
        <translation>M, Н·м</translation>
    </message>
    <message>
        <source>M about z₀, N·m</source>
        <translation>M относительно z₀, Н·м</translation>
    </message>
    <message>
        <source>Vertical plane, the paper&apos;s formulas (1) and (2), Fig. 6</source>
        <translation>Вертикальная плоскость, формулы статьи (1) и (2), рис. 6</translation>
    </message>
    <message>
        <source>Horizontal plane, the paper&apos;s formulas (3) and (4), Fig. 6</source>
        <translation>Горизонтальная плоскость, формулы статьи (3) и (4), рис. 6</translation>
    </message>
    <message>
        <source>In the vertical plane, exact</source>
        <translation>В вертикальной плоскости, точно</translation>
    </message>
    <message>
        <source>In the horizontal plane, exact</source>
        <translation>В горизонтальной плоскости, точно</translation>
    </message>
    <message>
        <source>Vertical plane, with rotating masses and with the counterweights and shafts that are on</source>
        <translation>Вертикальная плоскость, с вращающимися массами и включёнными противовесами и валами</translation>
    </message>
    <message>
        <source>Horizontal plane, likewise</source>
        <translation>Горизонтальная плоскость, так же</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Силы</translation>
    </message>
    <message>
        <source>Moments about z₀</source>
        <translation>Моменты относительно z₀</translation>
    </message>
    <message>
        <source>Fx, N</source>
        <translation>Fx, Н</translation>
    </message>
    <message>
        <source>Mx, N·m</source>
        <translation>Mx, Н·м</translation>
    </message>
    <message>
        <source>Fy, N</source>
        <translation>Fy, Н</translation>
    </message>
    <message>
        <source>My, N·m</source>
        <translation>My, Н·м</translation>
    </message>
    <message>
        <source>Exact first order (Fig. 5)</source>
        <translation>Точный первый порядок (рис. 5)</translation>
    </message>
    <message>
        <source>Exact second order (Fig. 5)</source>
        <translation>Точный второй порядок (рис. 5)</translation>
    </message>
    <message>
        <source>All orders, exact</source>
        <translation>Все порядки, точно</translation>
    </message>
    <message>
        <source>All orders with rotating masses, and with the counterweights and shafts that are on</source>
        <translation>Все порядки с вращающимися массами и включёнными противовесами и валами</translation>
    </message>
    <message>
        <source>Hodographs</source>
        <translation>Годографы</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>Порядки</translation>
    </message>
    <message>
        <source>Roll moment on the engine</source>
        <translation>Опрокидывающий момент двигателя</translation>
    </message>
    <message>
        <source>N·m</source>
        <translation>Н·м</translation>
    </message>
    <message>
        <source>Roll moment on the engine: the sum of the two</source>
        <translation>Опрокидывающий момент двигателя: сумма двух</translation>
    </message>
    <message>
        <source>Moment of the inertia forces about the crank axis: −Σ e F and the couples of rigid rods</source>
        <translation>Момент сил инерции относительно оси вала: −Σ e F и моменты твёрдых шатунов</translation>
    </message>
    <message>
        <source>reaction torque</source>
        <translation>реакция</translation>
    </message>
    <message>
        <source>Reaction of the inertia torque on the crank, −Σ F ds/dφ</source>
        <translation>Реакция инерционного крутящего момента, −Σ F ds/dφ</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Момент Mz</translation>
    </message>
    <message>
        <source>Order 1, forces</source>
        <translation>1-й порядок, силы</translation>
    </message>
    <message>
        <source>Order 2, forces</source>
        <translation>2-й порядок, силы</translation>
    </message>
    <message>
        <source>F, N</source>
        <translation>F, Н</translation>
    </message>
    <message>
        <source>Forces over φ</source>
        <translation>Силы от φ</translation>
    </message>
    <message>
        <source>Moments over φ</source>
        <translation>Моменты от φ</translation>
    </message>
    <message>
        <source>By the two-term formulas: orders 1 and 2</source>
        <translation>По двучленным формулам: порядки 1 и 2</translation>
    </message>
    <message>
        <source>With rotating masses, and with the counterweights and shafts that are on</source>
        <translation>С вращающимися массами и с включёнными противовесами и валами</translation>
    </message>
    <message>
        <source>Over φ</source>
        <translation>От φ</translation>
    </message>
    <message>
        <source>Forces and moments of all orders over two turns</source>
        <translation>Силы и моменты всех порядков за два оборота</translation>
    </message>
    <message>
        <source>Orders 1, 2</source>
        <translation>Порядки 1, 2</translation>
    </message>
    <message>
        <source>Roll moment without balancing</source>
        <translation>Опрокидывающий момент без уравновешивания</translation>
    </message>
    <message>
        <source>Sum of −m a of all moving parts, exact, all orders</source>
        <translation>Сумма −m a всех движущихся масс, точно: со всеми порядками</translation>
    </message>
    <message>
        <source>vertical (%1)</source>
        <translation>вертик. (%1)</translation>
    </message>
    <message>
        <source>horiz. (%1)</source>
        <translation>гориз. (%1)</translation>
    </message>
    <message>
        <source>2-term (%1)</source>
        <translation>2 члена (%1)</translation>
    </message>
    <message>
        <source>residual (%1)</source>
        <translation>остаток (%1)</translation>
    </message>
    <message>
        <source>roll (Mz)</source>
        <translation>опрокид. (Mz)</translation>
    </message>
    <message>
        <source>1st order</source>
        <translation>1-й порядок</translation>
    </message>
    <message>
        <source>2nd order</source>
        <translation>2-й порядок</translation>
    </message>
    <message>
        <source>all orders</source>
        <translation>все порядки</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>остаток</translation>
    </message>
    <message>
        <source>offsets and rods</source>
        <translation>дезаксажи и шатуны</translation>
    </message>
    <message>
        <source>Forces by order</source>
        <translation>Силы по порядкам</translation>
    </message>
    <message>
        <source>Moments by order</source>
        <translation>Моменты по порядкам</translation>
    </message>
    <message>
        <source>order k</source>
        <translation>порядок k</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>точно</translation>
    </message>
    <message>
        <source>two-term</source>
        <translation>два члена</translation>
    </message>
    <message>
        <source>Roll moment by order</source>
        <translation>Опрокидывающий момент по порядкам</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Анализ</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Подбор</translation>
    </message>
</context>
<context>
    <name>ravnoves::InertiaMomentsModel</name>
    <message>
        <source>VW VR5 (paper)</source>
        <translation>VW VR5 (статья)</translation>
    </message>
    <message>
        <source>Own table</source>
        <translation>Своя таблица</translation>
    </message>
    <message>
        <source>VR%1</source>
        <translation>VR%1</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Компоновка</translation>
    </message>
    <message>
        <source>Even firing</source>
        <translation>Равномерные вспышки</translation>
    </message>
    <message>
        <source>Add shaft</source>
        <translation>Добавление вала</translation>
    </message>
    <message>
        <source>Remove shaft</source>
        <translation>Удаление вала</translation>
    </message>
    <message>
        <source>Shaft on</source>
        <translation>Вал включён</translation>
    </message>
    <message>
        <source>Shaft off</source>
        <translation>Вал выключен</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>phase, °</source>
        <translation>фаза, °</translation>
    </message>
    <message>
        <source>δ, %</source>
        <translation>δ, %</translation>
    </message>
    <message>
        <source>+kω</source>
        <translation>+kω</translation>
    </message>
    <message>
        <source>at, °</source>
        <translation>угол, °</translation>
    </message>
    <message>
        <source>−kω</source>
        <translation>−kω</translation>
    </message>
    <message>
        <source>cancels</source>
        <translation>гасит</translation>
    </message>
    <message>
        <source>mρ, g·mm</source>
        <translation>mρ, г·мм</translation>
    </message>
    <message>
        <source>Rotating masses</source>
        <translation>Вращающиеся массы</translation>
    </message>
    <message>
        <source>value</source>
        <translation>значение</translation>
    </message>
    <message>
        <source>angle, °</source>
        <translation>угол, °</translation>
    </message>
    <message>
        <source>lag, °</source>
        <translation>отст., °</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>Сила, Н</translation>
    </message>
    <message>
        <source>Moment about zₘ, N·m</source>
        <translation>Момент отн. zₘ, Н·м</translation>
    </message>
    <message>
        <source>against the force</source>
        <translation>против силы</translation>
    </message>
    <message>
        <source>against the moment</source>
        <translation>против момента</translation>
    </message>
    <message>
        <source>, g·mm</source>
        <translation>, г·мм</translation>
    </message>
    <message>
        <source>, g</source>
        <translation>, г</translation>
    </message>
    <message>
        <source>Front web</source>
        <translation>Перед. щека</translation>
    </message>
    <message>
        <source>Rear web</source>
        <translation>Задняя щека</translation>
    </message>
    <message>
        <source>before</source>
        <translation>до</translation>
    </message>
    <message>
        <source>On a throw, rods: %1, g</source>
        <translation>Колено, ×%1, г</translation>
    </message>
    <message>
        <source>Articulated rods</source>
        <translation>Прицепные шатуны</translation>
    </message>
    <message>
        <source>Radial %1</source>
        <translation>Звезда %1</translation>
    </message>
    <message>
        <source>Amplitude by the paper&apos;s cos θ + K λ sin θ + λ cos 2θ</source>
        <translation>Амплитуда по формуле статьи cos θ + K λ sin θ + λ cos 2θ</translation>
    </message>
    <message>
        <source>Part B that turns against the crank</source>
        <translation>Часть B, вращающаяся против вала</translation>
    </message>
    <message>
        <source>Direction of the part to the left at φ = 0, counter-clockwise from x</source>
        <translation>Направление части слева при φ = 0, против часовой стрелки от x</translation>
    </message>
    <message>
        <source>Order, task and direction; a full dot is switched on</source>
        <translation>Порядок, задача и направление; закрашенная точка — включён</translation>
    </message>
    <message>
        <source>Weight times radius: m ρ (kω)² is the force, m ρ L (kω)² the moment cancelled</source>
        <translation>Масса на радиус: m ρ (kω)² — сила, m ρ L (kω)² — момент, которые он уравновешивает</translation>
    </message>
    <message>
        <source>From crankpin 1, counter-clockwise</source>
        <translation>От шейки 1 против часовой стрелки</translation>
    </message>
    <message>
        <source>From crankpin 1 against the rotation</source>
        <translation>От шейки 1 против вращения</translation>
    </message>
    <message>
        <source>%1, rods: %2</source>
        <translation>%1, шатунов: %2</translation>
    </message>
    <message>
        <source>Force to the right; the number is its order</source>
        <translation>Сила вправо; число — её порядок</translation>
    </message>
    <message>
        <source>Force upwards; the number is its order</source>
        <translation>Сила вверх; число — её порядок</translation>
    </message>
    <message>
        <source>Moment in the horizontal plane, Σ Fx (z − z₀)</source>
        <translation>Момент в горизонтальной плоскости, Σ Fx (z − z₀)</translation>
    </message>
    <message>
        <source>Moment in the vertical plane, Σ Fy (z − z₀)</source>
        <translation>Момент в вертикальной плоскости, Σ Fy (z − z₀)</translation>
    </message>
    <message>
        <source>%1 about z₀</source>
        <translation>%1 отн. z₀</translation>
    </message>
    <message>
        <source>Roll moment on the engine, of offsets, rods and the reaction of the torque</source>
        <translation>Опрокидывающий момент двигателя: от дезаксажей, шатунов и реакции крутящего момента</translation>
    </message>
    <message>
        <source>Force of the order k = the number</source>
        <translation>Сила порядка k, равного числу</translation>
    </message>
    <message>
        <source>Moment of the order k = the number</source>
        <translation>Момент порядка k, равного числу</translation>
    </message>
    <message>
        <source>The part of the order that the shaft cancels</source>
        <translation>Часть порядка, которую вал уравновешивает</translation>
    </message>
    <message>
        <source>Part A that turns with the crank: x + iy = A exp(ikφ) + B exp(−ikφ)</source>
        <translation>Часть A, вращающаяся с валом: x + iy = A exp(ikφ) + B exp(−ikφ)</translation>
    </message>
    <message>
        <source>Enter a firing order for even firing.</source>
        <translation>Введите порядок работы для равномерных вспышек.</translation>
    </message>
    <message>
        <source>Articulated rods run on their master&apos;s crankpin and cannot be separated.</source>
        <translation>Прицепные шатуны стоят на шейке главного: разделить их нельзя.</translation>
    </message>
    <message>
        <source>kφ of the maximum of the exact component</source>
        <translation>kφ максимума точной составляющей</translation>
    </message>
    <message>
        <source>Error of the two-term form, relative to exact</source>
        <translation>Погрешность двучленной формулы, в долях точной</translation>
    </message>
    <message>
        <source>Direction of its weight (towards cylinder 1) at φ = 0, counter-clockwise from x</source>
        <translation>Направление его груза (того, что к цилиндру 1) при φ = 0, против часовой стрелки от x</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>остаток</translation>
    </message>
    <message>
        <source>recip. left</source>
        <translation>остаток (поступ.)</translation>
    </message>
    <message>
        <source>Maximum of the reciprocating masses&apos; order with this shaft alone; the rotating masses are not in it</source>
        <translation>Максимум порядка поступательных масс с одним этим валом; вращающиеся массы в него не входят</translation>
    </message>
    <message>
        <source>Force of the rotating masses, m R ω² |Σ exp(iκ)|</source>
        <translation>Сила вращающихся масс, m R ω² |Σ exp(iκ)|</translation>
    </message>
    <message>
        <source>Moment of the rotating masses, m R ω² |Σ (z − zₘ) exp(iκ)|, about zₘ, the mean axial position of the crankpins. Other moments are about z₀.</source>
        <translation>Момент вращающихся масс, m R ω² |Σ (z − zₘ) exp(iκ)|, относительно zₘ — среднего положения шеек вдоль вала. Остальные моменты — относительно z₀.</translation>
    </message>
    <message>
        <source>Place of a counterweight against the force</source>
        <translation>Место противовеса против силы</translation>
    </message>
    <message>
        <source>Place of the front one of two opposite counterweights against the moment</source>
        <translation>Место переднего из двух противоположных противовесов против момента</translation>
    </message>
    <message>
        <source>Rotating mass on one crankpin with this number of rods, at the crank radius</source>
        <translation>Вращающаяся масса на одной шейке с таким числом шатунов, на радиусе кривошипа</translation>
    </message>
    <message>
        <source>Mass times radius of the front counterweight</source>
        <translation>Масса на радиус переднего противовеса</translation>
    </message>
    <message>
        <source>Mass of the front counterweight at its radius</source>
        <translation>Масса переднего противовеса на его радиусе</translation>
    </message>
    <message>
        <source>Mass times radius of the rear counterweight</source>
        <translation>Масса на радиус заднего противовеса</translation>
    </message>
    <message>
        <source>Mass of the rear counterweight at its radius</source>
        <translation>Масса заднего противовеса на его радиусе</translation>
    </message>
    <message>
        <source>Maximum over a turn, with the rotating masses, without balancing</source>
        <translation>Максимум за оборот, с вращающимися массами, без уравновешивания</translation>
    </message>
    <message>
        <source>Maximum with the counterweights and shafts that are on</source>
        <translation>Максимум с включёнными противовесами и валами</translation>
    </message>
    <message>
        <source>residual, %</source>
        <translation>ост., %</translation>
    </message>
    <message>
        <source>Residual relative to the value before balancing</source>
        <translation>Остаток в долях значения до уравновешивания</translation>
    </message>
    <message>
        <source>recipr. exact</source>
        <translation>поступ. точно</translation>
    </message>
    <message>
        <source>Amplitude of the order of the reciprocating masses, exact motion</source>
        <translation>Амплитуда порядка поступательных масс при точном движении</translation>
    </message>
    <message>
        <source>recipr. two-term</source>
        <translation>2 члена</translation>
    </message>
    <message>
        <source>Own table, cylinders: %1</source>
        <translation>Своя таблица, цилиндров: %1</translation>
    </message>
</context>
<context>
    <name>ravnoves::InertiaMomentsPage</name>
    <message>
        <source>&amp;Shafts on or off</source>
        <translation>&amp;Валы вкл/выкл</translation>
    </message>
    <message>
        <source>Switch all balance shafts on, or off when all are on</source>
        <translation>Включить все балансирные валы или выключить, когда все включены</translation>
    </message>
    <message>
        <source>All shafts off</source>
        <translation>Все валы выключены</translation>
    </message>
    <message>
        <source>All shafts on</source>
        <translation>Все валы включены</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Двигатель</translation>
    </message>
    <message>
        <source>Cylinders</source>
        <translation>Цилиндры</translation>
    </message>
    <message>
        <source>Balancing</source>
        <translation>Баланс</translation>
    </message>
    <message>
        <source>Crank angle of the picture, from cylinder 1&apos;s axis</source>
        <translation>Угол кривошипа на рисунке, от оси цилиндра 1</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>Порядки</translation>
    </message>
    <message>
        <source>Amplitudes and phases by order and plane</source>
        <translation>Амплитуды и фазы по порядкам и плоскостям</translation>
    </message>
    <message>
        <source>±kω</source>
        <translation>±kω</translation>
    </message>
    <message>
        <source>Forward and backward rotating parts by order</source>
        <translation>Прямые и обратные вращающиеся части по порядкам</translation>
    </message>
    <message>
        <source>Shafts</source>
        <translation>Валы</translation>
    </message>
    <message>
        <source>Balance shafts</source>
        <translation>Балансирные валы</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Грузы</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Остаток</translation>
    </message>
    <message>
        <source>Residual by order</source>
        <translation>Остаток по порядкам</translation>
    </message>
</context>
<context>
    <name>ravnoves::JobDesk</name>
    <message>
        <source>The journal is backed up: %1</source>
        <translation>Резервная копия журнала: %1</translation>
    </message>
    <message>
        <source>without an engine number</source>
        <translation>без номера двигателя</translation>
    </message>
    <message>
        <source>Job %1 saved in the journal.</source>
        <translation>Работа %1 сохранена в журнале.</translation>
    </message>
    <message>
        <source>Job %1 put aside in the journal, unfinished.</source>
        <translation>Работа %1 отложена в журнал незаконченной.</translation>
    </message>
    <message>
        <source>The job&apos;s sheet cannot be read: %1</source>
        <translation>Лист работы не читается: %1</translation>
    </message>
    <message>
        <source>Jobs restored: %1; already in the journal: %2.</source>
        <translation>Возвращено работ: %1; уже есть в журнале: %2.</translation>
    </message>
    <message>
        <source>The sheet is empty: not saved.</source>
        <translation>Лист пуст: не сохранено.</translation>
    </message>
    <message>
        <source>The journal is not available.</source>
        <translation>Журнал недоступен.</translation>
    </message>
    <message>
        <source>Job %1 was changed by another program: saved as a new job.</source>
        <translation>Работа %1 изменена другой программой: сохранено как новая работа.</translation>
    </message>
    <message>
        <source>Enter a number of engine or crankshaft, or a customer, to find the job again.</source>
        <translation>Введите номер двигателя или коленвала либо заказчика, чтобы найти работу.</translation>
    </message>
</context>
<context>
    <name>ravnoves::JobSheet</name>
    <message>
        <source>Notes on the job card</source>
        <translation>Примечания на карте</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Двигатель</translation>
    </message>
    <message>
        <source>Sludge-trap plugs</source>
        <translation>Заглушки грязеуловителей</translation>
    </message>
    <message>
        <source>The crankpins have sludge-trap &amp;plugs</source>
        <translation>В шатунных шейках есть &amp;заглушки грязеуловителей</translation>
    </message>
    <message>
        <source>Crankpin plugs of a V-8 at 90° are bored or replaced to balance heavier or lighter parts.</source>
        <translation>Заглушки шатунных шеек V-8 с углом 90° растачивают или заменяют, чтобы уравновесить более тяжёлые или лёгкие детали.</translation>
    </message>
    <message>
        <source>Balance the crankshaft with damper and flywheel in place, each in its position.</source>
        <translation>Балансируйте с гасителем и маховиком, каждый на своём месте.</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Работа</translation>
    </message>
    <message>
        <source>“%1” is not a date; example: %2.</source>
        <translation>«%1» — не дата; пример: %2.</translation>
    </message>
</context>
<context>
    <name>ravnoves::Journal</name>
    <message>
        <source>The journal&apos;s folder %1 cannot be created.</source>
        <translation>Не удалось создать папку журнала %1.</translation>
    </message>
    <message>
        <source>The journal is not open.</source>
        <translation>Журнал не открыт.</translation>
    </message>
    <message>
        <source>The journal %1 cannot be opened.</source>
        <translation>Журнал %1 не открывается.</translation>
    </message>
    <message>
        <source>The journal %1 cannot be read.</source>
        <translation>Журнал %1 не читается.</translation>
    </message>
    <message>
        <source>The journal %1 was written by a newer program; update to open it.</source>
        <translation>Журнал %1 записан более новой программой; обновите программу.</translation>
    </message>
    <message>
        <source>The job could not be read.</source>
        <translation>Работу не удалось прочесть.</translation>
    </message>
    <message>
        <source>The journal could not be searched.</source>
        <translation>Поиск по журналу не удался.</translation>
    </message>
    <message>
        <source>The job could not be removed.</source>
        <translation>Работу не удалось удалить.</translation>
    </message>
    <message>
        <source>The draft could not be removed.</source>
        <translation>Черновик не удалось удалить.</translation>
    </message>
    <message>
        <source>The drafts could not be read.</source>
        <translation>Черновики не удалось прочесть.</translation>
    </message>
    <message>
        <source>The engine could not be removed.</source>
        <translation>Двигатель не удалось удалить.</translation>
    </message>
    <message>
        <source>The engines could not be read.</source>
        <translation>Двигатели не удалось прочесть.</translation>
    </message>
    <message>
        <source>The backup %1 could not be written.</source>
        <translation>Не удалось записать резервную копию %1.</translation>
    </message>
    <message>
        <source>another program is writing to the journal</source>
        <translation>в журнал пишет другая программа</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>файл не открывается</translation>
    </message>
    <message>
        <source>the file is damaged</source>
        <translation>файл повреждён</translation>
    </message>
    <message>
        <source>Its last backup is from %1.</source>
        <translation>Последняя резервная копия от %1.</translation>
    </message>
    <message>
        <source>Nothing was restored.</source>
        <translation>Ничего не восстановлено.</translation>
    </message>
    <message>
        <source>The job could not be saved in the journal.</source>
        <translation>Работу не удалось записать в журнал: запись не создана.</translation>
    </message>
    <message>
        <source>the saved data differ</source>
        <translation>записанные данные отличаются</translation>
    </message>
    <message>
        <source>The job was removed from the journal.</source>
        <translation>Эта работа удалена из журнала.</translation>
    </message>
    <message>
        <source>%1 belongs to another program or was changed by one; it was not changed.</source>
        <translation>%1 принадлежит другой программе или изменена ею; файл не изменён.</translation>
    </message>
    <message>
        <source>The journal %1 is damaged and cannot be renamed; it was not changed.</source>
        <translation>Журнал %1 повреждён, переименовать его не удалось; он не изменён.</translation>
    </message>
    <message>
        <source>The journal was damaged. The file is now %1, and a new journal was created.</source>
        <translation>Журнал был повреждён. Теперь это файл %1, создан новый журнал.</translation>
    </message>
    <message>
        <source>%1 is not a backup of a journal, or is damaged.</source>
        <translation>%1 — не резервная копия журнала, или файл повреждён.</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>диск заполнен</translation>
    </message>
    <message>
        <source>the journal is read-only</source>
        <translation>журнал доступен только для чтения</translation>
    </message>
    <message>
        <source>disk error</source>
        <translation>ошибка диска</translation>
    </message>
</context>
<context>
    <name>ravnoves::JournalDialog</name>
    <message>
        <source>Journal of jobs</source>
        <translation>Журнал работ</translation>
    </message>
    <message>
        <source>&amp;Search</source>
        <translation>&amp;Поиск</translation>
    </message>
    <message>
        <source>Jobs found</source>
        <translation>Найденные работы</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Дата</translation>
    </message>
    <message>
        <source>Engine number</source>
        <translation>Номер двигателя</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Заказчик</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Двигатель</translation>
    </message>
    <message>
        <source>Technician</source>
        <translation>Исполнитель</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Итог</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Открыть</translation>
    </message>
    <message>
        <source>&amp;Copy as new job</source>
        <translation>&amp;Копировать как новую</translation>
    </message>
    <message>
        <source>&amp;Remove…</source>
        <translation>&amp;Удалить…</translation>
    </message>
    <message>
        <source>&amp;Export list as CSV…</source>
        <translation>&amp;Выгрузить список в CSV…</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>&amp;Закрыть</translation>
    </message>
    <message>
        <source>No job found.</source>
        <translation>Работ не найдено.</translation>
    </message>
    <message>
        <source>Jobs found: %1</source>
        <translation>Найдено работ: %1</translation>
    </message>
    <message>
        <source>Remove job</source>
        <translation>Удаление работы</translation>
    </message>
    <message>
        <source>Export list</source>
        <translation>Выгрузка списка</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
    <message>
        <source>The newest %1 jobs; more match. The export has them all.</source>
        <translation>Последние работы: %1; найдено больше. В выгрузке будут все.</translation>
    </message>
    <message>
        <source>Crankshaft</source>
        <translation>Коленвал</translation>
    </message>
    <message>
        <source>Bob weight, g</source>
        <translation>Груз, г</translation>
    </message>
    <message>
        <source>Machine, g·mm</source>
        <translation>Станок, г·мм</translation>
    </message>
    <message>
        <source>engine or crankshaft number, customer, technician, %1 or %2</source>
        <translation>номер двигателя или вала, заказчик, исполнитель, %1 или %2</translation>
    </message>
    <message>
        <source>&amp;unfinished only</source>
        <translation>&amp;незаконченные</translation>
    </message>
    <message>
        <source>unfinished</source>
        <translation>не закончена</translation>
    </message>
    <message>
        <source>Remove job %1 of %2 from the journal permanently?</source>
        <translation>Удалить работу %1 от %2 из журнала навсегда?</translation>
    </message>
</context>
<context>
    <name>ravnoves::MachineSheet</name>
    <message>
        <source>Planes</source>
        <translation>Плоскости</translation>
    </message>
    <message>
        <source>Readings: before, and after each drilling</source>
        <translation>Показания: до и после каждого сверления</translation>
    </message>
    <message>
        <source>Kind of limit</source>
        <translation>Вид допуска</translation>
    </message>
    <message>
        <source>&amp;For</source>
        <translation>&amp;Для чего</translation>
    </message>
    <message>
        <source>New jobs begin with this set-up.</source>
        <translation>Новые работы начинаются с этой настройки.</translation>
    </message>
    <message>
        <source>Save as shop default (&amp;machine)</source>
        <translation>Сохранить &amp;станок для мастерской</translation>
    </message>
    <message>
        <source>Permissible residual</source>
        <translation>Допустимый остаток</translation>
    </message>
    <message>
        <source>&amp;Own limit for each plane, instead of a grade</source>
        <translation>&amp;Свой предел для каждой плоскости вместо класса</translation>
    </message>
    <message>
        <source>On: permissible residual in each plane. Off: by grade, mass and speed.</source>
        <translation>Включено: допустимый остаток в каждой плоскости. Выключено: по классу, массе и частоте.</translation>
    </message>
    <message>
        <source>own grade</source>
        <translation>свой класс</translation>
    </message>
    <message>
        <source>Balance quality grades of ISO 21940-11 and their uses.</source>
        <translation>Классы точности балансировки ИСО 21940-11 и их применение.</translation>
    </message>
    <message>
        <source>Readings are still &amp;valid</source>
        <translation>Показания &amp;верны</translation>
    </message>
    <message>
        <source>The readings are of this crankshaft, with the present bob weight.</source>
        <translation>Показания сняты с этого вала, с текущим грузом.</translation>
    </message>
    <message>
        <source>Balancing machine</source>
        <translation>Балансировочный станок</translation>
    </message>
    <message>
        <source>Type two names, such as left / right.</source>
        <translation>Введите два названия, например левая / правая.</translation>
    </message>
</context>
<context>
    <name>ravnoves::MainWindow</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Файл</translation>
    </message>
    <message>
        <source>&amp;New case</source>
        <translation>&amp;Новая задача</translation>
    </message>
    <message>
        <source>&amp;Open case…</source>
        <translation>&amp;Открыть задачу…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Открыть не&amp;давнюю</translation>
    </message>
    <message>
        <source>&amp;Save case</source>
        <translation>&amp;Сохранить задачу</translation>
    </message>
    <message>
        <source>Save case &amp;as…</source>
        <translation>Сохранить задачу &amp;как…</translation>
    </message>
    <message>
        <source>Save page as &amp;picture…</source>
        <translation>Сохранить страницу как &amp;рисунок…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>В&amp;ыход</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Правка</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Отменить</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Вернуть</translation>
    </message>
    <message>
        <source>Copy results as &amp;text</source>
        <translation>Копировать результаты как &amp;текст</translation>
    </message>
    <message>
        <source>Copy results</source>
        <translation>Скопировать результаты</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Настройки</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Весы</translation>
    </message>
    <message>
        <source>Results copied as text</source>
        <translation>Результаты скопированы как текст</translation>
    </message>
    <message>
        <source>Copy results as &amp;CSV</source>
        <translation>Копировать результаты как &amp;CSV</translation>
    </message>
    <message>
        <source>Results copied as CSV</source>
        <translation>Результаты скопированы как CSV</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Вид</translation>
    </message>
    <message>
        <source>Reset &amp;zoom of all plots</source>
        <translation>Сбросить &amp;масштаб всех графиков</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Полный экран</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Справка</translation>
    </message>
    <message>
        <source>&amp;About this page: formulas and sources</source>
        <translation>Об этой &amp;странице: формулы и источники</translation>
    </message>
    <message>
        <source>&amp;Case files and command line</source>
        <translation>&amp;Файлы задач и командная строка</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Клавиши и мышь</translation>
    </message>
    <message>
        <source>About &amp;Ravnoves</source>
        <translation>О &amp;программе Ravnoves</translation>
    </message>
    <message>
        <source>Main toolbar</source>
        <translation>Главная панель</translation>
    </message>
    <message>
        <source>Open case</source>
        <translation>Открыть задачу</translation>
    </message>
    <message>
        <source>Ravnoves cases (*.case.json *.json);;All files (*)</source>
        <translation>Задачи Ravnoves (*.case.json *.json);;Все файлы (*)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Сохранено: %1</translation>
    </message>
    <message>
        <source>Save page as picture</source>
        <translation>Сохранить страницу как рисунок</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Файлов ещё нет</translation>
    </message>
    <message>
        <source>About Ravnoves</source>
        <translation>О программе Ravnoves</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Ravnoves %1&lt;/h3&gt;&lt;p&gt;The engine-balancing workbench.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later; it comes without any warranty.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Ravnoves %1&lt;/h3&gt;&lt;p&gt;Рабочее место для уравновешивания двигателей.&lt;/p&gt;&lt;p&gt;Свободная программа на условиях GNU General Public License версии 3 или более поздней; без каких-либо гарантий.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Начало</translation>
    </message>
    <message>
        <source>Repor&amp;t…</source>
        <translation>От&amp;чёт…</translation>
    </message>
    <message>
        <source>&amp;Close case</source>
        <translation>&amp;Закрыть задачу</translation>
    </message>
    <message>
        <source>Title and &amp;notes…</source>
        <translation>Название и &amp;заметки…</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Настройки…</translation>
    </message>
    <message>
        <source>Ne&amp;xt case</source>
        <translation>&amp;Следующая задача</translation>
    </message>
    <message>
        <source>Pre&amp;vious case</source>
        <translation>Пр&amp;едыдущая задача</translation>
    </message>
    <message>
        <source>New case</source>
        <translation>Новая задача</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Отчёт</translation>
    </message>
    <message>
        <source>Web page</source>
        <translation>Веб-страница</translation>
    </message>
    <message>
        <source>Report written: %1</source>
        <translation>Отчёт записан: %1</translation>
    </message>
    <message>
        <source>T&amp;olerances…</source>
        <translation>&amp;Допуски…</translation>
    </message>
    <message>
        <source>Sca&amp;le…</source>
        <translation>Вес&amp;ы…</translation>
    </message>
    <message>
        <source>Writing the report…</source>
        <translation>Пишется отчёт…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>Cancelled: the report was not written.</source>
        <translation>Отменено: отчёт не записан.</translation>
    </message>
    <message>
        <source>&amp;What’s this?</source>
        <translation>Что &amp;это?</translation>
    </message>
    <message>
        <source>Save %1</source>
        <translation>Сохранить %1</translation>
    </message>
    <message>
        <source>This page has no case file: its numbers are measured each time. Copy or export them.</source>
        <translation>У этой страницы нет файла задачи: её числа каждый раз измеряются. Скопируйте или запишите их.</translation>
    </message>
    <message>
        <source>Modules, recent files, examples</source>
        <translation>Модули, недавние файлы, примеры</translation>
    </message>
    <message>
        <source>&amp;Variants: one design compared with another</source>
        <translation>&amp;Варианты: сравнение конструкций</translation>
    </message>
    <message>
        <source>&amp;Tolerances: how certain a result is</source>
        <translation>&amp;Допуски: насколько надёжен результат</translation>
    </message>
    <message>
        <source>Take the &amp;engine from</source>
        <translation>Взять дви&amp;гатель из</translation>
    </message>
    <message>
        <source>No other open case has an engine</source>
        <translation>В других открытых задачах двигателя нет</translation>
    </message>
    <message>
        <source>Take the engine from %1</source>
        <translation>Взять двигатель из %1</translation>
    </message>
    <message>
        <source>The engine is already the same as in %1.</source>
        <translation>Двигатель уже такой же, как в %1.</translation>
    </message>
    <message>
        <source>Copied from %1: %2.</source>
        <translation>Скопировано из %1: %2.</translation>
    </message>
    <message>
        <source>New case &amp;from</source>
        <translation>Новая задача &amp;из</translation>
    </message>
    <message>
        <source>New case with placeholder values (%1)</source>
        <translation>Новая задача со значениями-заготовками (%1)</translation>
    </message>
    <message>
        <source>Unchanged: %1.</source>
        <translation>Не изменены: %1.</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Отменено: %1</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>Повторено: %1</translation>
    </message>
</context>
<context>
    <name>ravnoves::MechanismView</name>
    <message>
        <source>Front view of the mechanism</source>
        <translation>Механизм, вид спереди</translation>
    </message>
    <message>
        <source>Front view to scale; the crank turns clockwise. Drag the shaft to change α, drag elsewhere to turn the crank, Space plays and pauses.</source>
        <translation>Вид спереди в масштабе; коленчатый вал вращается по часовой стрелке. Потяните вал — меняется α, потяните в другом месте — поворачивается кривошип; пробел — пуск и пауза.</translation>
    </message>
    <message>
        <source>φ = %1°</source>
        <translation>φ = %1°</translation>
    </message>
    <message>
        <source>does not fit</source>
        <translation>не помещается</translation>
    </message>
    <message>
        <source>piston (Pⱼ₁)</source>
        <translation>поршень (Pⱼ₁)</translation>
    </message>
    <message>
        <source>crank weight (P₁)</source>
        <translation>противовес кривошипа (P₁)</translation>
    </message>
    <message>
        <source>shaft weight (P₁)</source>
        <translation>противовес вала (P₁)</translation>
    </message>
</context>
<context>
    <name>ravnoves::MethodPlots</name>
    <message>
        <source>Time and error</source>
        <translation>Время и погрешность</translation>
    </message>
    <message>
        <source>Error along the hard parameter</source>
        <translation>Погрешность вдоль трудного параметра</translation>
    </message>
    <message>
        <source>time of one evaluation</source>
        <translation>время одного вычисления</translation>
    </message>
    <message>
        <source>error</source>
        <translation>погрешность</translation>
    </message>
    <message>
        <source>%1, half of the runs from %2 to %3</source>
        <translation>%1, половина прогонов от %2 до %3</translation>
    </message>
    <message>
        <source>error %1</source>
        <translation>погрешность %1</translation>
    </message>
    <message>
        <source>within the tolerance</source>
        <translation>в пределах допуска</translation>
    </message>
    <message>
        <source>beyond the tolerance</source>
        <translation>вне допуска</translation>
    </message>
    <message>
        <source>%1: time and error</source>
        <translation>%1: время и погрешность</translation>
    </message>
    <message>
        <source>time: %1</source>
        <translation>время: %1</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>в программе</translation>
    </message>
    <message>
        <source>%1: stability</source>
        <translation>%1: устойчивость</translation>
    </message>
    <message>
        <source>%1 fails</source>
        <translation>%1: не годится</translation>
    </message>
    <message>
        <source>preset</source>
        <translation>исходное</translation>
    </message>
    <message>
        <source>measuring…</source>
        <translation>идёт измерение…</translation>
    </message>
    <message>
        <source>tolerance, %1</source>
        <translation>допуск, %1</translation>
    </message>
    <message>
        <source>not an input</source>
        <translation>вне данных</translation>
    </message>
</context>
<context>
    <name>ravnoves::MethodWords</name>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>мс</translation>
    </message>
    <message>
        <source>µs</source>
        <translation>мкс</translation>
    </message>
    <message>
        <source>ns</source>
        <translation>нс</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>отказ</translation>
    </message>
</context>
<context>
    <name>ravnoves::MethodsPage</name>
    <message>
        <source>%1 (in use)</source>
        <translation>%1 (в программе)</translation>
    </message>
    <message>
        <source>&amp;Measure again</source>
        <translation>&amp;Измерить снова</translation>
    </message>
    <message>
        <source>Measure this kernel again, with more repetitions (F5)</source>
        <translation>Измерить эту величину ещё раз, с большим числом повторений (F5)</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Величина</translation>
    </message>
    <message>
        <source>Hard parameter</source>
        <translation>Трудный параметр</translation>
    </message>
    <message>
        <source>&amp;Quantity</source>
        <translation>&amp;Величина</translation>
    </message>
    <message>
        <source>&amp;Hard parameter</source>
        <translation>&amp;Трудный параметр</translation>
    </message>
    <message>
        <source>&amp;Value measured at</source>
        <translation>&amp;Измерено при</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Ход измерения</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>О&amp;тменить</translation>
    </message>
    <message>
        <source>Methods as measured</source>
        <translation>Методы по измерениям</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Метод</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Настройка</translation>
    </message>
    <message>
        <source>Time, ns</source>
        <translation>Время, нс</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Погрешность</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Порядок</translation>
    </message>
    <message>
        <source>Beyond the tolerance</source>
        <translation>Вне допуска</translation>
    </message>
    <message>
        <source>Median of repeated runs; the tips of the cells have the quartiles</source>
        <translation>Медиана повторных прогонов; квартили — в подсказках ячеек</translation>
    </message>
    <message>
        <source>Speed and accuracy</source>
        <translation>Скорость и точность</translation>
    </message>
    <message>
        <source>Validation report</source>
        <translation>Сверка со статьями</translation>
    </message>
    <message>
        <source>%1, %2. Tolerance: %3, %4.</source>
        <translation>%1, %2. Допуск: %3, %4.</translation>
    </message>
    <message>
        <source>One evaluation</source>
        <translation>Одно вычисление</translation>
    </message>
    <message>
        <source>Half of the runs from %1 to %2</source>
        <translation>Половина прогонов от %1 до %2</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Beyond the tolerance: %1.</source>
        <translation>Вне допуска: %1.</translation>
    </message>
    <message>
        <source>Quantity to measure: the numerical kernels of the modules</source>
        <translation>Измеряемая величина: численные задачи модулей</translation>
    </message>
    <message>
        <source>Parameter that makes the problem harder; the right chart shows the errors along it</source>
        <translation>Параметр, который усложняет задачу; правый график показывает погрешности вдоль него</translation>
    </message>
    <message>
        <source>Stop measuring and keep the previous results</source>
        <translation>Прекратить измерение, прежние результаты сохранить</translation>
    </message>
    <message>
        <source>Methods for the quantity; the method in use is marked</source>
        <translation>Методы вычисления величины; применяемый выделен</translation>
    </message>
    <message>
        <source>Steps, terms or samples of the method</source>
        <translation>Шаги, члены или пробы метода</translation>
    </message>
    <message>
        <source>Maximum error against 50 digits, in the measure of the quantity</source>
        <translation>Максимальная погрешность относительно 50 знаков, в мере этой величины</translation>
    </message>
    <message>
        <source>Order of convergence: the error falls as this power of the number of steps</source>
        <translation>Порядок сходимости: погрешность падает как эта степень числа шагов</translation>
    </message>
    <message>
        <source>Method in use, and reason</source>
        <translation>Применяемый метод и почему</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Эталон</translation>
    </message>
    <message>
        <source>The same quantity in 50 digits, without the module&apos;s formulas: %1.</source>
        <translation>Та же величина с 50 знаками, не по формулам модуля: %1.</translation>
    </message>
    <message>
        <source>rejected: %1</source>
        <translation>отказ: %1</translation>
    </message>
    <message>
        <source>Within the tolerance</source>
        <translation>В пределах допуска</translation>
    </message>
    <message>
        <source>This case</source>
        <translation>Эта задача</translation>
    </message>
    <message>
        <source>Contributions to the results</source>
        <translation>Вклады в результаты</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The model leaves out:</source>
        <translation>Модель не учитывает:</translation>
    </message>
    <message>
        <source>&amp;Details</source>
        <translation>&amp;Подробности</translation>
    </message>
    <message>
        <source>Show times, orders of convergence and how both are measured</source>
        <translation>Показать время, порядок сходимости и как они измерены</translation>
    </message>
</context>
<context>
    <name>ravnoves::NewCases</name>
    <message>
        <source>How much can a balance shaft help?</source>
        <translation>Насколько поможет балансирный вал?</translation>
    </message>
    <message>
        <source>Which hinge can be made?</source>
        <translation>Какой шарнир можно изготовить?</translation>
    </message>
    <message>
        <source>Preset: %1</source>
        <translation>Образец: %1</translation>
    </message>
    <message>
        <source>Example: %1</source>
        <translation>Пример: %1</translation>
    </message>
    <message>
        <source>TMZ-650D: balance shaft</source>
        <translation>ТМЗ-650Д: балансирный вал</translation>
    </message>
    <message>
        <source>Zotov and Sviridov 2021: formulas as printed</source>
        <translation>Зотов и Свиридов 2021: формулы как напечатаны</translation>
    </message>
    <message>
        <source>Zotov and Sviridov 2021: counterweight on the rod</source>
        <translation>Зотов и Свиридов 2021: противовес на шатуне</translation>
    </message>
    <message>
        <source>Zotov and Sviridov 2021: guide that keeps the energy</source>
        <translation>Зотов и Свиридов 2021: сохраняет энергию</translation>
    </message>
    <message>
        <source>V-8 of 4.25 litres: repair with oversize pistons</source>
        <translation>V-8, 4,25 л: ремонт с увеличенными поршнями</translation>
    </message>
    <message>
        <source>V-8 of 6 litres: improved pistons and rods</source>
        <translation>V-8, 6 л: улучшенные поршни и шатуны</translation>
    </message>
    <message>
        <source>V-8, 90°: bob weight and correction</source>
        <translation>V-8, 90°: груз и коррекция</translation>
    </message>
    <message>
        <source>Volkswagen VR5 at 6200 min⁻¹</source>
        <translation>Volkswagen VR5 при 6200 мин⁻¹</translation>
    </message>
    <message>
        <source>Radial engine of nine cylinders</source>
        <translation>Звезда из девяти цилиндров</translation>
    </message>
    <message>
        <source>V-8 4.25 l: plugs, bob weight, second run on the machine</source>
        <translation>V-8 4,25 л: заглушки, балансировочный груз, второй пуск на станке</translation>
    </message>
    <message>
        <source>Where do I put the balance shaft?</source>
        <translation>Где поставить балансирный вал?</translation>
    </message>
    <message>
        <source>What do elastic hinges change?</source>
        <translation>Что меняют упругие шарниры?</translation>
    </message>
    <message>
        <source>Which counterweight does the rod need?</source>
        <translation>Какой противовес нужен шатуну?</translation>
    </message>
    <message>
        <source>Which guide keeps the crank speed constant?</source>
        <translation>Какая направляющая держит скорость кривошипа постоянной?</translation>
    </message>
    <message>
        <source>Which plugs compensate oversize pistons?</source>
        <translation>Какие заглушки компенсируют ремонтные поршни?</translation>
    </message>
    <message>
        <source>Which plugs suit lighter pistons and rods?</source>
        <translation>Какие заглушки подходят к облегчённым поршням и шатунам?</translation>
    </message>
    <message>
        <source>How heavy is the bob weight, and where do I drill?</source>
        <translation>Какова масса балансировочного груза и где сверлить?</translation>
    </message>
    <message>
        <source>How is a crankshaft balanced from start to finish?</source>
        <translation>Как балансируют вал от начала до конца?</translation>
    </message>
    <message>
        <source>How much does a VR5 shake?</source>
        <translation>Насколько трясёт VR5?</translation>
    </message>
    <message>
        <source>How much does a radial engine shake?</source>
        <translation>Насколько трясёт звездообразный двигатель?</translation>
    </message>
    <message>
        <source>Blank (placeholder values)</source>
        <translation>С чистого листа (значения-заготовки)</translation>
    </message>
    <message>
        <source>88 × 75 mm: a balance shaft that helps</source>
        <translation>88 × 75 мм: балансирный вал, который помогает</translation>
    </message>
    <message>
        <source>Elastic hinge that can be made: softer spring, roller of 10 mm</source>
        <translation>Упругий шарнир, который можно изготовить: пружина мягче, ролик 10 мм</translation>
    </message>
</context>
<context>
    <name>ravnoves::NumberField</name>
    <message>
        <source>“%1” is not a number.</source>
        <translation>«%1» — не число.</translation>
    </message>
    <message>
        <source>The value %1.</source>
        <translation>Значение %1.</translation>
    </message>
    <message>
        <source>Value %1.</source>
        <translation>Значение %1.</translation>
    </message>
    <message>
        <source>The value must be a whole number.</source>
        <translation>Значение должно быть целым числом.</translation>
    </message>
    <message>
        <source>“%1” is a unit, but this value has no unit.</source>
        <translation>«%1» — единица, а у этого значения единицы нет.</translation>
    </message>
    <message>
        <source>“%1” is not a unit of this value (%2).</source>
        <translation>«%1» — не единица этого значения (%2).</translation>
    </message>
    <message>
        <source>“%1” may be %2 or %3: enter one of them.</source>
        <translation>«%1» можно прочесть как %2 и как %3: введите одно из них.</translation>
    </message>
    <message>
        <source>Enter a value: %1.</source>
        <translation>Введите значение: %1.</translation>
    </message>
    <message>
        <source>“%1” was read as %2. Type %3 if that is meant.</source>
        <translation>«%1» прочитано как %2. Если имеется в виду %3, введите это число.</translation>
    </message>
    <message>
        <source>“%1” at a radius of %2: %3.</source>
        <translation>«%1» на радиусе %2: %3.</translation>
    </message>
    <message>
        <source>Grams need the drilling radius of the plane: enter it first. If two planes have different radii, enter %1.</source>
        <translation>Для граммов нужен радиус сверления плоскости: сначала введите его. Если радиусы плоскостей разные, введите %1.</translation>
    </message>
</context>
<context>
    <name>ravnoves::PageColumns</name>
    <message>
        <source>Results</source>
        <translation>Результаты</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Графики</translation>
    </message>
</context>
<context>
    <name>ravnoves::PartsSheet</name>
    <message>
        <source>Parts of one cylinder</source>
        <translation>Детали одного цилиндра</translation>
    </message>
    <message>
        <source>Balance factor</source>
        <translation>Коэффициент балансировки</translation>
    </message>
    <message>
        <source>Parts of one cylinder, heavier than nominal by (negative: lighter)</source>
        <translation>Детали одного цилиндра тяжелее номинала на (минус: легче)</translation>
    </message>
    <message>
        <source>Nominal masses, for the bob weight</source>
        <translation>Номинальные массы, для груза</translation>
    </message>
    <message>
        <source>&amp;Fill from the nominal parts</source>
        <translation>&amp;Заполнить по номинальным деталям</translation>
    </message>
    <message>
        <source>Reciprocating: piston, pin, rings, small end; rotating: big end and shells, by the nominal masses of the weigh-in sheet.</source>
        <translation>Поступательная: поршень, палец, кольца, верхняя головка; вращающаяся: нижняя головка и вкладыши, по номинальным массам листа «Взвешивание».</translation>
    </message>
    <message>
        <source>Limit of the plugs</source>
        <translation>Предел для заглушек</translation>
    </message>
    <message>
        <source>New jobs begin with this limit.</source>
        <translation>С этим пределом начинаются новые работы.</translation>
    </message>
    <message>
        <source>Grey values are means of the weigh-in sheet.</source>
        <translation>Серые значения — средние листа взвешивания.</translation>
    </message>
    <message>
        <source>&amp;Save as shop default</source>
        <translation>&amp;Сохранить для мастерской</translation>
    </message>
</context>
<context>
    <name>ravnoves::PictureFile</name>
    <message>
        <source>%1: a picture is written as .png, .svg or .pdf.</source>
        <translation>%1: рисунок записывается как .png, .svg или .pdf.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>Не удалось записать %1.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
</context>
<context>
    <name>ravnoves::PicturePanel</name>
    <message>
        <source>Play or pause the picture</source>
        <translation>Пуск или пауза рисунка</translation>
    </message>
    <message>
        <source>&amp;φ</source>
        <translation>&amp;φ</translation>
    </message>
    <message>
        <source>Turn the crank</source>
        <translation>Вращать кривошип</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Пауза</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Пуск</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Пауза (пробел)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Пуск (пробел)</translation>
    </message>
</context>
<context>
    <name>ravnoves::PlaneView</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 под углом %2</translation>
    </message>
    <message>
        <source>no correction yet</source>
        <translation>коррекции пока нет</translation>
    </message>
    <message>
        <source>Arrow: reading; dashed circle: limit; dot: residual; rim: holes and slugs, existing holes dimmed. Front view, angles as on the machine.</source>
        <translation>Стрелка: показание; штриховая окружность: предел; точка: остаток; обод: отверстия и вставки, имеющиеся отверстия бледнее. Вид спереди, углы как на станке.</translation>
    </message>
</context>
<context>
    <name>ravnoves::PlotSentence</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 при %2</translation>
    </message>
    <message>
        <source>constant, %1</source>
        <translation>постоянно %1</translation>
    </message>
    <message>
        <source>from %1 at %2 to %3 at %4</source>
        <translation>от %1 при %2 до %3 при %4</translation>
    </message>
    <message>
        <source>Over %1 from %2 to %3.</source>
        <translation>По оси %1 от %2 до %3.</translation>
    </message>
    <message>
        <source>No data.</source>
        <translation>Данных нет.</translation>
    </message>
    <message>
        <source>Marked: %1.</source>
        <translation>Отмечено: %1.</translation>
    </message>
    <message>
        <source>Now at %1.</source>
        <translation>Сейчас %1.</translation>
    </message>
</context>
<context>
    <name>ravnoves::PlotView</name>
    <message>
        <source>Show %1</source>
        <translation>Показать: %1</translation>
    </message>
    <message>
        <source>Show or hide %1</source>
        <translation>Показать или скрыть: %1</translation>
    </message>
    <message>
        <source>Reset zoom</source>
        <translation>Сбросить масштаб</translation>
    </message>
    <message>
        <source>Show reference %1</source>
        <translation>Показать эталон %1</translation>
    </message>
    <message>
        <source>Show or hide the curves of the reference %1</source>
        <translation>Показать или скрыть кривые эталона %1</translation>
    </message>
    <message>
        <source>5…95 %</source>
        <translation>5…95&#xa0;%</translation>
    </message>
    <message>
        <source>Range from 5 % to 95 % of the curve, with the tolerances of the case.</source>
        <translation>Диапазон кривой от 5 % до 95 % при допусках задачи.</translation>
    </message>
    <message>
        <source>Show the tolerance band</source>
        <translation>Показать полосу допусков</translation>
    </message>
    <message>
        <source>Click or drag: choose the value; wheel: zoom; middle button: pan; double click: show all.</source>
        <translation>Щелчок или перетаскивание: выбрать значение; колесо: масштаб; средняя кнопка: сдвиг; двойной щелчок: показать всё.</translation>
    </message>
    <message>
        <source>Wheel: zoom, with Shift in y, with Ctrl in x; drag: pan; double click: show all.</source>
        <translation>Колесо: масштаб, с Shift по y, с Ctrl по x; перетаскивание: сдвиг; двойной щелчок: показать всё.</translation>
    </message>
</context>
<context>
    <name>ravnoves::PlugView</name>
    <message>
        <source>Plug in section</source>
        <translation>Заглушка в разрезе</translation>
    </message>
    <message>
        <source>Plug</source>
        <translation>Заглушка</translation>
    </message>
    <message>
        <source>Section of the plug of sheet 4, to scale; sizes without a unit are in millimetres.</source>
        <translation>Заглушка с листа 4 в разрезе, в масштабе; размеры без единицы — в миллиметрах.</translation>
    </message>
</context>
<context>
    <name>ravnoves::PlugsSheet</name>
    <message>
        <source>No plugs: tick “The crankpins have sludge-trap plugs” on the sheet Job.</source>
        <translation>Заглушек нет: отметьте на листе «Работа», что в шатунных шейках есть заглушки.</translation>
    </message>
    <message>
        <source>Only a V-8 at 90° with two rods on a crankpin has sludge-trap plugs.</source>
        <translation>Заглушки грязеуловителей бывают только у V-8 с углом 90° и двумя шатунами на шейке.</translation>
    </message>
    <message>
        <source>There are &amp;aluminium plugs</source>
        <translation>Есть &amp;алюминиевые заглушки</translation>
    </message>
    <message>
        <source>There are plugs of the new &amp;design</source>
        <translation>Есть заглушки &amp;новой конструкции</translation>
    </message>
    <message>
        <source>Crankshaft and present plugs</source>
        <translation>Вал и существующие заглушки</translation>
    </message>
    <message>
        <source>Sizes of the present plug</source>
        <translation>Размеры существующей заглушки</translation>
    </message>
    <message>
        <source>Options include aluminium plugs instead of steel plugs.</source>
        <translation>Варианты включают алюминиевые заглушки вместо стальных.</translation>
    </message>
    <message>
        <source>Options include plugs of the new design, for a crankshaft made for them.</source>
        <translation>Варианты включают новые заглушки, для изготовленного под них вала.</translation>
    </message>
    <message>
        <source>“%1” is not a metric thread with pitch; example: %2.</source>
        <translation>«%1» — не метрическая резьба с шагом; пример: %2.</translation>
    </message>
    <message>
        <source>All plugs are treated as equal: enter the mean mass. Match plugs that differ by more than 0.5 g.</source>
        <translation>Все заглушки считаются одинаковыми: введите среднюю массу. Заглушки с разницей более 0,5 г подгоните.</translation>
    </message>
</context>
<context>
    <name>ravnoves::Recovery</name>
    <message>
        <source>Unsaved changes are not protected against a crash: %1</source>
        <translation>Несохранённые изменения не защищены от сбоя: %1</translation>
    </message>
    <message>
        <source>%1 is not writable</source>
        <translation>в %1 нельзя писать</translation>
    </message>
</context>
<context>
    <name>ravnoves::RecoveryDialog</name>
    <message>
        <source>Unsaved cases</source>
        <translation>Несохранённые задачи</translation>
    </message>
    <message>
        <source>The program ended unexpectedly. These cases were not saved:</source>
        <translation>Программа завершилась неожиданно. Эти задачи не были сохранены:</translation>
    </message>
    <message>
        <source>no file yet</source>
        <translation>ещё без файла</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Восстановить</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Закрыть</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Позже</translation>
    </message>
    <message>
        <source>Ask again at the next start</source>
        <translation>Спросить при следующем запуске</translation>
    </message>
    <message>
        <source>The copy of an unsaved case cannot be read; it is now %1.</source>
        <translation>Копию несохранённой задачи прочитать не удалось; теперь это файл %1.</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Удалить</translation>
    </message>
    <message>
        <source>Delete these cases permanently? Cases that will be deleted: %1.</source>
        <translation>Удалить эти задачи навсегда? Будет удалено: %1.</translation>
    </message>
</context>
<context>
    <name>ravnoves::ReferenceCase</name>
    <message>
        <source>Reference %1: %2</source>
        <translation>Эталон %1: %2</translation>
    </message>
</context>
<context>
    <name>ravnoves::RejectedEntries</name>
    <message>
        <source>&amp;Stay</source>
        <translation>&amp;Остаться</translation>
    </message>
    <message>
        <source>These entries were not accepted and are left out:</source>
        <translation>Эти значения не приняты и опущены:</translation>
    </message>
    <message>
        <source>These entries were not accepted; the previous values are used:</source>
        <translation>Эти значения не приняты; используются прежние:</translation>
    </message>
    <message>
        <source>&amp;Continue without them</source>
        <translation>&amp;Продолжить без них</translation>
    </message>
</context>
<context>
    <name>ravnoves::RelievedShaftDrawing</name>
    <message>
        <source>Drawing of the shaft with a relieved middle</source>
        <translation>Чертёж вала с лыской</translation>
    </message>
    <message>
        <source>No shaft of these sizes</source>
        <translation>Вала таких размеров нет</translation>
    </message>
    <message>
        <source>Bar of %1, its middle cut %2 deep over %3.</source>
        <translation>Пруток %1, середина снята на глубину %2 по длине %3.</translation>
    </message>
</context>
<context>
    <name>ravnoves::ReportDialog</name>
    <message>
        <source>Report</source>
        <translation>Отчёт</translation>
    </message>
    <message>
        <source>The first page has the answer: verdict, picture, leading results, variants.</source>
        <translation>На первой странице ответ: вывод, рисунок, главные результаты, варианты.</translation>
    </message>
    <message>
        <source>&amp;Inputs</source>
        <translation>&amp;Исходные данные</translation>
    </message>
    <message>
        <source>All inputs with their units.</source>
        <translation>Все исходные данные с единицами.</translation>
    </message>
    <message>
        <source>&amp;Plots and tables</source>
        <translation>&amp;Графики и таблицы</translation>
    </message>
    <message>
        <source>The plots and tables of each tab of the page.</source>
        <translation>Графики и таблицы каждой вкладки.</translation>
    </message>
    <message>
        <source>&amp;Formulas and what the model leaves out</source>
        <translation>&amp;Формулы и чего модель не учитывает</translation>
    </message>
    <message>
        <source>Each formula with its source.</source>
        <translation>Каждая формула с источником.</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letter</translation>
    </message>
    <message>
        <source>Paper of a PDF file.</source>
        <translation>Бумага файла PDF.</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>&amp;Бумага</translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation>&amp;Сохранить как…</translation>
    </message>
</context>
<context>
    <name>ravnoves::ReportWords</name>
    <message>
        <source>SHA-256 of the file</source>
        <translation>SHA-256 файла</translation>
    </message>
    <message>
        <source>SHA-256 of the case, with changes that are not saved</source>
        <translation>SHA-256 задачи с несохранёнными изменениями</translation>
    </message>
    <message>
        <source>Case file</source>
        <translation>Файл задачи</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Программа</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Дата</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Заметки</translation>
    </message>
    <message>
        <source>Formulas</source>
        <translation>Формулы</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Величина</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Формула</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Источник</translation>
    </message>
    <message>
        <source>What the model leaves out</source>
        <translation>Чего модель не учитывает</translation>
    </message>
    <message>
        <source>Report of a calculation: %1</source>
        <translation>Отчёт о расчёте: %1</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Исходные данные</translation>
    </message>
    <message>
        <source>%1: the name of a report ends in .pdf or .html</source>
        <translation>%1: имя отчёта кончается на .pdf или .html</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Величина</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Значение</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Ед.</translation>
    </message>
    <message>
        <source>%1 values, %2 … %3</source>
        <translation>значений: %1, %2 … %3</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Таблица</translation>
    </message>
    <message>
        <source>Fig.</source>
        <translation>Рис.</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Страница %1 из %2</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Варианты</translation>
    </message>
    <message>
        <source>Inputs and their tolerances</source>
        <translation>Исходные данные и допуски</translation>
    </message>
    <message>
        <source>Method: %1</source>
        <translation>Метод: %1</translation>
    </message>
    <message>
        <source>samples: %1, seed %2</source>
        <translation>выборка: %1, начальное число %2</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Допуски</translation>
    </message>
    <message>
        <source>derived, see Help (F1)</source>
        <translation>вывод — в справке (F1)</translation>
    </message>
    <message>
        <source>, not numbered there</source>
        <translation>, там без номера</translation>
    </message>
    <message>
        <source>A section: the plot is zoomed.</source>
        <translation>Часть графика: он увеличен.</translation>
    </message>
    <message>
        <source>Not given</source>
        <translation>Не задано</translation>
    </message>
    <message>
        <source>Assumed</source>
        <translation>Принято</translation>
    </message>
    <message>
        <source>Results with tolerances</source>
        <translation>Результаты с допусками</translation>
    </message>
    <message>
        <source>Bands about curves and ± beside numbers are the range from 5 % to 95 % of 128 samples.</source>
        <translation>Полосы вокруг кривых и ± у чисел — диапазон от 5 % до 95 % по 128 пробам.</translation>
    </message>
    <message>
        <source>Both include the uncertain dead centre of the trace, the results below do not.</source>
        <translation>В них учтена неточность мёртвой точки диаграммы, в результатах ниже — нет.</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Задача</translation>
    </message>
    <message>
        <source>Plots and tables</source>
        <translation>Графики и таблицы</translation>
    </message>
    <message>
        <source>SHA-256 of the file as read; the file has changed</source>
        <translation>SHA-256 прочитанного файла; файл изменился</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>Модуль</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Пояснение</translation>
    </message>
    <message>
        <source>No results.</source>
        <translation>Результатов нет.</translation>
    </message>
    <message>
        <source>Only differences are listed, inputs first; in brackets the difference from the reference. ★ marks the best of those without a warning.</source>
        <translation>Перечислено только то, что отличается, сначала исходные данные; в скобках разность с эталоном. ★ отмечает лучшее из вариантов без предупреждений.</translation>
    </message>
    <message>
        <source>In the plots the curves of %1 are dimmed and wide.</source>
        <translation>На графиках кривые %1 бледные и широкие.</translation>
    </message>
    <message>
        <source>Sweep, %1 from %2 to %3. %4</source>
        <translation>Вариация параметра, %1 от %2 до %3. %4</translation>
    </message>
    <message>
        <source>Not used: other inputs replace it</source>
        <translation>Не используется: заменено другими данными</translation>
    </message>
</context>
<context>
    <name>ravnoves::ResultTable</name>
    <message>
        <source>Copy selection</source>
        <translation>Копировать выделенное</translation>
    </message>
    <message>
        <source>Copy table as text</source>
        <translation>Копировать таблицу как текст</translation>
    </message>
    <message>
        <source>Copy table as CSV</source>
        <translation>Копировать таблицу как CSV</translation>
    </message>
    <message>
        <source>Ctrl+C copies the selected cells, or the whole table if no more than one is selected.</source>
        <translation>Ctrl+C копирует выделенные ячейки, а если выделено не больше одной — всю таблицу.</translation>
    </message>
    <message>
        <source>Copy as &amp;text</source>
        <translation>Копировать как &amp;текст</translation>
    </message>
    <message>
        <source>Copy as &amp;CSV</source>
        <translation>Копировать как &amp;CSV</translation>
    </message>
    <message>
        <source>Present value minus reference %1</source>
        <translation>Текущее значение минус эталон %1</translation>
    </message>
    <message>
        <source>Below the value: difference from the reference.</source>
        <translation>Под значением: разность с эталоном.</translation>
    </message>
</context>
<context>
    <name>ravnoves::ScaleButton</name>
    <message>
        <source>Scale: ready</source>
        <translation>Весы: готовы</translation>
    </message>
    <message>
        <source>Scale: not connected</source>
        <translation>Весы: не подключены</translation>
    </message>
    <message>
        <source>Scale: %1</source>
        <translation>Весы: %1</translation>
    </message>
    <message>
        <source>Masses are entered in the field with the focus. Click for settings.</source>
        <translation>Масса вводится в поле с курсором. Щелчок — настройки.</translation>
    </message>
    <message>
        <source>%1 not entered: sent again too soon. If the scale sends continuously, change its settings.</source>
        <translation>%1 не введено: повторная передача слишком скоро. Если весы передают непрерывно, измените их настройки.</translation>
    </message>
</context>
<context>
    <name>ravnoves::ScaleDialog</name>
    <message>
        <source>Scale</source>
        <translation>Весы</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>Пор&amp;т</translation>
    </message>
    <message>
        <source>&amp;Baud rate</source>
        <translation>&amp;Скорость, бод</translation>
    </message>
    <message>
        <source>P&amp;arity</source>
        <translation>&amp;Чётность</translation>
    </message>
    <message>
        <source>none, 8 bits</source>
        <translation>нет, 8 бит</translation>
    </message>
    <message>
        <source>even, 7 bits</source>
        <translation>чётная, 7 бит</translation>
    </message>
    <message>
        <source>odd, 7 bits</source>
        <translation>нечётная, 7 бит</translation>
    </message>
    <message>
        <source>even, 8 bits</source>
        <translation>чётная, 8 бит</translation>
    </message>
    <message>
        <source>odd, 8 bits</source>
        <translation>нечётная, 8 бит</translation>
    </message>
    <message>
        <source>&amp;Last digit d, %1</source>
        <translation>Последний &amp;знак d, %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>Connected to %1.</source>
        <translation>Подключены: %1.</translation>
    </message>
    <message>
        <source>Lines from the &amp;scale</source>
        <translation>Стр&amp;оки с весов</translation>
    </message>
    <message>
        <source>Lines from the scale</source>
        <translation>Строки с весов</translation>
    </message>
    <message>
        <source>Press Print on the scale: its lines and their meaning appear here.</source>
        <translation>Нажмите «Печать» на весах: здесь появятся их строки и значения.</translation>
    </message>
    <message>
        <source>Port of the scale; you can type a path such as /dev/ttyUSB0.</source>
        <translation>Порт весов; можно ввести путь, например /dev/ttyUSB0.</translation>
    </message>
    <message>
        <source>Same setting as in the scale&apos;s own menu.</source>
        <translation>Как в меню самих весов.</translation>
    </message>
    <message>
        <source>&amp;Unit of bare numbers</source>
        <translation>&amp;Единица чисел без единицы</translation>
    </message>
    <message>
        <source>Unit of lines that contain only a number.</source>
        <translation>Единица строк, где только число.</translation>
    </message>
    <message>
        <source>&amp;Enter a weight</source>
        <translation>&amp;Вводить вес</translation>
    </message>
    <message>
        <source>Stable weights only. Each is entered in the field with the focus; the focus moves to the next field.</source>
        <translation>Только установившийся вес. Он вводится в поле с курсором, и курсор переходит в следующее.</translation>
    </message>
    <message>
        <source>at each line (the scale sends on Print)</source>
        <translation>с каждой строки: весы посылают по клавише «Печать»</translation>
    </message>
    <message>
        <source>once for each part (the scale sends continuously)</source>
        <translation>один раз с детали: весы посылают постоянно</translation>
    </message>
    <message>
        <source>Smallest step of the display; the uncertainty of masses follows. Also for a keyboard scale or manual reading.</source>
        <translation>Наименьший шаг дисплея; из него следует неопределённость масс. Также для весов-клавиатуры и чтения вручную.</translation>
    </message>
    <message>
        <source>No scale is connected. A scale that acts as a keyboard needs no settings.</source>
        <translation>Весы не подключены. Весам-клавиатуре настройки не нужны.</translation>
    </message>
</context>
<context>
    <name>ravnoves::ScaleInput</name>
    <message>
        <source>%1 from the scale: %2</source>
        <translation>%1 с весов: %2</translation>
    </message>
    <message>
        <source>%1 from the scale is not accepted. %2</source>
        <translation>%1 с весов не принято. %2</translation>
    </message>
    <message>
        <source>%1 from the scale was not entered: click a mass field first.</source>
        <translation>%1 с весов не введено: сначала щёлкните по полю массы.</translation>
    </message>
    <message>
        <source>%1, stable</source>
        <translation>%1, установились</translation>
    </message>
    <message>
        <source>%1, not settled</source>
        <translation>%1, не установились</translation>
    </message>
    <message>
        <source>too much on the pan</source>
        <translation>перегрузка</translation>
    </message>
    <message>
        <source>too little on the pan</source>
        <translation>недогрузка</translation>
    </message>
    <message>
        <source>not understood</source>
        <translation>непонятно</translation>
    </message>
    <message>
        <source>no weight</source>
        <translation>не вес</translation>
    </message>
</context>
<context>
    <name>ravnoves::ScaleReader</name>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>%1 не открывается: %2</translation>
    </message>
    <message>
        <source>The scale was unplugged. It reconnects automatically.</source>
        <translation>Весы отключены. Они подключатся автоматически.</translation>
    </message>
    <message>
        <source>%1 does not exist: check that the scale is plugged in.</source>
        <translation>%1 нет: проверьте, подключены ли весы.</translation>
    </message>
    <message>
        <source>%1 cannot be opened: another program uses it, or you are not in the group dialout.</source>
        <translation>%1 не открывается: порт занят другой программой, или вас нет в группе dialout.</translation>
    </message>
    <message>
        <source>Expected lines such as “%1”, got “%2”. For another scale open Edit ▸ Scale….</source>
        <translation>Ожидаются строки вида «%1», пришло «%2». Для других весов откройте «Правка ▸ Весы…».</translation>
    </message>
</context>
<context>
    <name>ravnoves::ScatterTable</name>
    <message>
        <source>Input</source>
        <translation>Величина</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Значение</translation>
    </message>
    <message>
        <source>0.02: uniform within ± 0.02. 1 %: uniform within ± 1 % of the value. σ 0.01: normal with this standard deviation.</source>
        <translation>0,02 или 1 %: равномерно в пределах ± 0,02 или ± 1 % от значения. σ 0,01: нормально с этим стандартным отклонением.</translation>
    </message>
</context>
<context>
    <name>ravnoves::SceneList</name>
    <message>
        <source>Methods</source>
        <translation>Методы</translation>
    </message>
    <message>
        <source>Numerical methods: speed, accuracy, limits</source>
        <translation>Численные методы: скорость, точность, пределы</translation>
    </message>
</context>
<context>
    <name>ravnoves::SceneModel</name>
    <message>
        <source>Open case</source>
        <translation>Открытие задачи</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>да</translation>
    </message>
    <message>
        <source>no</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>Title and notes</source>
        <translation>Название и заметки</translation>
    </message>
    <message>
        <source>%1 (changed)</source>
        <translation>%1 (изменено)</translation>
    </message>
    <message>
        <source>Keep variant %1</source>
        <translation>Сохранение варианта %1</translation>
    </message>
    <message>
        <source>Rename variant</source>
        <translation>Переименование варианта</translation>
    </message>
    <message>
        <source>Delete variant %1</source>
        <translation>Удаление варианта %1</translation>
    </message>
    <message>
        <source>%1 has changed since this variant was kept: its results use the present file.</source>
        <translation>%1 изменился с тех пор, как сохранён этот вариант: его результаты — по текущему файлу.</translation>
    </message>
    <message>
        <source>Enter a name for the variant.</source>
        <translation>Введите имя варианта.</translation>
    </message>
    <message>
        <source>Another variant has the name %1.</source>
        <translation>Имя %1 у другого варианта.</translation>
    </message>
    <message>
        <source>Use variant %1</source>
        <translation>Применение варианта %1</translation>
    </message>
</context>
<context>
    <name>ravnoves::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Настройки</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Язык</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Тема</translation>
    </message>
    <message>
        <source>Light or dark colours.</source>
        <translation>Светлые или тёмные цвета.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Светлая</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Тёмная</translation>
    </message>
    <message>
        <source>small, 85 %</source>
        <translation>мелкий, 85&#xa0;%</translation>
    </message>
    <message>
        <source>normal, 100 %</source>
        <translation>обычный, 100&#xa0;%</translation>
    </message>
    <message>
        <source>large, 125 %</source>
        <translation>крупный, 125&#xa0;%</translation>
    </message>
    <message>
        <source>very large, 150 %</source>
        <translation>очень крупный, 150&#xa0;%</translation>
    </message>
    <message>
        <source>largest, 200 %</source>
        <translation>самый крупный, 200&#xa0;%</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>&amp;Размер текста</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>автоматически</translation>
    </message>
    <message>
        <source>%1 significant digits</source>
        <translation>значащих цифр: %1</translation>
    </message>
    <message>
        <source>&amp;Digits of results</source>
        <translation>&amp;Цифры результатов</translation>
    </message>
    <message>
        <source>L&amp;engths</source>
        <translation>&amp;Длины</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>миллиметры</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>дюймы</translation>
    </message>
    <message>
        <source>&amp;Masses</source>
        <translation>&amp;Массы</translation>
    </message>
    <message>
        <source>kilograms and grams</source>
        <translation>килограммы и граммы</translation>
    </message>
    <message>
        <source>grams</source>
        <translation>граммы</translation>
    </message>
    <message>
        <source>pounds and ounces</source>
        <translation>фунты и унции</translation>
    </message>
    <message>
        <source>T&amp;orques</source>
        <translation>Мом&amp;енты сил</translation>
    </message>
    <message>
        <source>&amp;Forces</source>
        <translation>&amp;Силы</translation>
    </message>
    <message>
        <source>&amp;Speeds</source>
        <translation>&amp;Частоты вращения</translation>
    </message>
    <message>
        <source>&amp;Unbalances</source>
        <translation>&amp;Дисбалансы</translation>
    </message>
    <message>
        <source>as the masses</source>
        <translation>как массы</translation>
    </message>
    <message>
        <source>System default</source>
        <translation>Как в системе</translation>
    </message>
    <message>
        <source>Language of texts and numbers.</source>
        <translation>Язык текстов и чисел.</translation>
    </message>
    <message>
        <source>Size of all texts and fields.</source>
        <translation>Размер всех текстов и полей.</translation>
    </message>
    <message>
        <source>Automatic: digits as needed. Copies and exports use the same digits.</source>
        <translation>Автоматически: цифр столько, сколько нужно. То же в копиях и выгрузках.</translation>
    </message>
    <message>
        <source>Units of display, input, print and export. Case files keep their own units; drawings are in millimetres.</source>
        <translation>Единицы показа, ввода, печати и выгрузки. В файлах задач свои единицы; чертежи — в миллиметрах.</translation>
    </message>
    <message>
        <source>module default</source>
        <translation>как в модуле</translation>
    </message>
</context>
<context>
    <name>ravnoves::ShaftMapModel</name>
    <message>
        <source>range</source>
        <translation>размах</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>СКЗ</translation>
    </message>
    <message>
        <source>Move shaft</source>
        <translation>Перемещение вала</translation>
    </message>
    <message>
        <source>x, mm</source>
        <translation>x, мм</translation>
    </message>
    <message>
        <source>y, mm</source>
        <translation>y, мм</translation>
    </message>
    <message>
        <source>ΔMᵤₚₛ, N·m</source>
        <translation>ΔMᵤₚₛ, Н·м</translation>
    </message>
    <message>
        <source>RMS, N·m</source>
        <translation>СКЗ, Н·м</translation>
    </message>
    <message>
        <source>l %1, α %2°</source>
        <translation>l %1, α %2°</translation>
    </message>
    <message>
        <source>range %1</source>
        <translation>размах %1</translation>
    </message>
    <message>
        <source>RMS %1</source>
        <translation>СКЗ %1</translation>
    </message>
    <message>
        <source>box %1</source>
        <translation>габарит %1</translation>
    </message>
    <message>
        <source>From here: %1.</source>
        <translation>Отсюда: %1.</translation>
    </message>
    <message>
        <source>min. range, ignoring clearance</source>
        <translation>мин. размах, без учёта зазоров</translation>
    </message>
    <message>
        <source>min. RMS, ignoring clearance</source>
        <translation>мин. СКЗ, без учёта зазоров</translation>
    </message>
    <message>
        <source>Computing the map…</source>
        <translation>Карта вычисляется…</translation>
    </message>
    <message>
        <source>Worse than without a shaft.</source>
        <translation>Хуже, чем без вала.</translation>
    </message>
    <message>
        <source>%1 at %2 does not fit.</source>
        <translation>%1 при&#xa0;%2 не помещается.</translation>
    </message>
    <message>
        <source>feasible</source>
        <translation>допустимо</translation>
    </message>
    <message>
        <source>Compared with no shaft: %1.</source>
        <translation>По сравнению со схемой без вала: %1.</translation>
    </message>
    <message>
        <source>Already there, within 1 %.</source>
        <translation>Вал уже там, в пределах 1&#xa0;%.</translation>
    </message>
    <message>
        <source>best by range</source>
        <translation>лучшее по размаху</translation>
    </message>
    <message>
        <source>best by RMS</source>
        <translation>лучшее по СКЗ</translation>
    </message>
    <message>
        <source>Best place, the smallest box with the %1 within 1 % of its minimum: %2 at %3, box %4.</source>
        <translation>Лучшее место, наименьший габарит (%1 в пределах 1&#xa0;% от минимума): %2 при %3, габарит %4.</translation>
    </message>
</context>
<context>
    <name>ravnoves::ShaftMapPlot</name>
    <message>
        <source>computing…</source>
        <translation>вычисляется…</translation>
    </message>
    <message>
        <source>Drag the shaft, or double-click its new place. The sliders of l and α move it by keys.</source>
        <translation>Перетащите ось вала или дважды щёлкните по новому месту. С клавиатуры её сдвигают ползунки l и α.</translation>
    </message>
    <message>
        <source>Front view to scale; thick line: no change; hatched: does not fit. Drag the shaft, or double-click its new place (0.5 mm, 0.5°).</source>
        <translation>Вид спереди в масштабе; толстая линия: без изменений; штриховка: не помещается. Перетащите вал или дважды щёлкните по новому месту (0,5 мм, 0,5°).</translation>
    </message>
</context>
<context>
    <name>ravnoves::ShaftMapView</name>
    <message>
        <source>The place under the pointer, or the best one</source>
        <translation>Место под указателем или лучшее место</translation>
    </message>
    <message>
        <source>Front view</source>
        <translation>Спереди</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Границы</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>вычисляется…</translation>
    </message>
    <message>
        <source>Distance &amp;l</source>
        <translation>Расстояние &amp;l</translation>
    </message>
    <message>
        <source>&amp;Criterion</source>
        <translation>&amp;Критерий</translation>
    </message>
    <message>
        <source>range</source>
        <translation>размах</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>СКЗ</translation>
    </message>
    <message>
        <source>Criterion of the places of the shaft</source>
        <translation>Критерий выбора места вала</translation>
    </message>
    <message>
        <source>&amp;Best place</source>
        <translation>Лу&amp;чшее место</translation>
    </message>
    <message>
        <source>Limits on the shaft&apos;s axis</source>
        <translation>Границы для оси вала</translation>
    </message>
    <message>
        <source>Pareto</source>
        <translation>Парето</translation>
    </message>
    <message>
        <source>Distance from crank axis to shaft axis; α is kept.</source>
        <translation>Расстояние от оси кривошипа до оси вала; α сохраняется.</translation>
    </message>
    <message>
        <source>Further limits, for example a crankcase wall; blank means no limit.</source>
        <translation>Дополнительные ограничения, например стенка картера; пусто — без ограничения.</translation>
    </message>
    <message>
        <source>Feasible places that are Pareto-optimal in range, RMS and size. Click to move the shaft.</source>
        <translation>Допустимые места, оптимальные по Парето: размах, СКЗ, габарит. Щелчок переносит вал.</translation>
    </message>
    <message>
        <source>no feasible position</source>
        <translation>допустимых положений нет</translation>
    </message>
    <message>
        <source>Criterion of map and optimum, relative to no shaft: range of Mᵤₚₛ, or its RMS</source>
        <translation>Критерий карты и оптимума, относительно схемы без вала: размах Mᵤₚₛ или его СКЗ</translation>
    </message>
</context>
<context>
    <name>ravnoves::ShaftParts</name>
    <message>
        <source>Moments over the cycle</source>
        <translation>Моменты за цикл</translation>
    </message>
    <message>
        <source>N·m</source>
        <translation>Н·м</translation>
    </message>
    <message>
        <source>without shaft (Mᵤₚ)</source>
        <translation>без вала (Mᵤₚ)</translation>
    </message>
    <message>
        <source>Tipping moment: the reaction to the engine torque</source>
        <translation>Опрокидывающий момент: реакция на момент двигателя</translation>
    </message>
    <message>
        <source>shaft (Mₛ)</source>
        <translation>вал (Mₛ)</translation>
    </message>
    <message>
        <source>Moment of the balance shaft, P₁ l sin(α + φ), (4)</source>
        <translation>Момент балансирного вала, P₁ l sin(α + φ), (4)</translation>
    </message>
    <message>
        <source>with shaft (Mᵤₚₛ)</source>
        <translation>с валом (Mᵤₚₛ)</translation>
    </message>
    <message>
        <source>Moment on the mounts, Mᵤₚ + Mₛ, (5)</source>
        <translation>Момент на опорах, Mᵤₚ + Mₛ, (5)</translation>
    </message>
    <message>
        <source>Range and RMS over α</source>
        <translation>Размах и СКЗ от α</translation>
    </message>
    <message>
        <source>range (ΔMᵤₚₛ)</source>
        <translation>размах (ΔMᵤₚₛ)</translation>
    </message>
    <message>
        <source>Range of Mᵤₚₛ, max − min</source>
        <translation>Размах Mᵤₚₛ, максимум минус минимум</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>СКЗ</translation>
    </message>
    <message>
        <source>RMS of Mᵤₚₛ about its mean</source>
        <translation>Среднее квадратическое отклонение Mᵤₚₛ от среднего</translation>
    </message>
    <message>
        <source>Overall size over α</source>
        <translation>Габарит от α</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>мм</translation>
    </message>
    <message>
        <source>width</source>
        <translation>ширина</translation>
    </message>
    <message>
        <source>height</source>
        <translation>высота</translation>
    </message>
    <message>
        <source>Range and overall size, α along the curve</source>
        <translation>Размах и габарит, вдоль кривой меняется α</translation>
    </message>
    <message>
        <source>width × height, cm²</source>
        <translation>ширина × высота, см²</translation>
    </message>
    <message>
        <source>ΔMᵤₚₛ, N·m</source>
        <translation>ΔMᵤₚₛ, Н·м</translation>
    </message>
    <message>
        <source>all α</source>
        <translation>все α</translation>
    </message>
    <message>
        <source>feasible</source>
        <translation>допустимо</translation>
    </message>
    <message>
        <source>The shaft clears cylinder, crank and rod</source>
        <translation>Вал не задевает цилиндр, кривошип и шатун</translation>
    </message>
    <message>
        <source>Pareto-optimal</source>
        <translation>по Парето</translation>
    </message>
    <message>
        <source>Feasible and Pareto-optimal in size and range</source>
        <translation>Допустимо и оптимально по Парето: габарит и размах</translation>
    </message>
    <message>
        <source>present α</source>
        <translation>текущий α</translation>
    </message>
    <message>
        <source>Best α over speed</source>
        <translation>Лучший α от частоты</translation>
    </message>
    <message>
        <source>n, min⁻¹</source>
        <translation>n, мин⁻¹</translation>
    </message>
    <message>
        <source>α, °</source>
        <translation>α, °</translation>
    </message>
    <message>
        <source>range</source>
        <translation>размах</translation>
    </message>
    <message>
        <source>α of the minimum range at each speed</source>
        <translation>α минимального размаха при каждой частоте</translation>
    </message>
    <message>
        <source>α of the minimum RMS at each speed</source>
        <translation>α минимального СКЗ при каждой частоте</translation>
    </message>
    <message>
        <source>best compromise %1°</source>
        <translation>лучший компромисс %1°</translation>
    </message>
    <message>
        <source>Map over α and speed</source>
        <translation>Карта по α и частоте</translation>
    </message>
    <message>
        <source>best α</source>
        <translation>лучший α</translation>
    </message>
    <message>
        <source>x, mm</source>
        <translation>x, мм</translation>
    </message>
    <message>
        <source>y, mm</source>
        <translation>y, мм</translation>
    </message>
    <message>
        <source>Range and size</source>
        <translation>Размах и габарит</translation>
    </message>
    <message>
        <source>RMS and size</source>
        <translation>СКЗ и габарит</translation>
    </message>
    <message>
        <source>change, %</source>
        <translation>изменение, %</translation>
    </message>
    <message>
        <source>Pareto-optimal in range, RMS and size</source>
        <translation>Оптимально по Парето: размах, СКЗ, габарит</translation>
    </message>
    <message>
        <source>by this criterion</source>
        <translation>по этому критерию</translation>
    </message>
    <message>
        <source>Pareto-optimal in this criterion and size</source>
        <translation>Оптимально по Парето: этот критерий и габарит</translation>
    </message>
    <message>
        <source>present place</source>
        <translation>текущее место</translation>
    </message>
    <message>
        <source>Engine torque and its parts</source>
        <translation>Крутящий момент и его части</translation>
    </message>
    <message>
        <source>gas</source>
        <translation>газы</translation>
    </message>
    <message>
        <source>−(p − p₀) A s′</source>
        <translation>−(p − p₀) A s′</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>инерция</translation>
    </message>
    <message>
        <source>−mⱼ ω² s′ s″</source>
        <translation>−mⱼ ω² s′ s″</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>дезаксаж</translation>
    </message>
    <message>
        <source>e mⱼ ω² s″: part of Mᵤₚ due to the offset cylinder</source>
        <translation>e mⱼ ω² s″: добавка дезаксиального цилиндра к Mᵤₚ</translation>
    </message>
    <message>
        <source>engine torque</source>
        <translation>момент двигателя</translation>
    </message>
    <message>
        <source>Gas plus inertia</source>
        <translation>Газы и инерция вместе</translation>
    </message>
    <message>
        <source>Cylinder pressure</source>
        <translation>Давление в цилиндре</translation>
    </message>
    <message>
        <source>bar</source>
        <translation>бар</translation>
    </message>
    <message>
        <source>Indicator diagram, p–V</source>
        <translation>Индикаторная диаграмма p–V</translation>
    </message>
    <message>
        <source>V without clearance, cm³</source>
        <translation>V без камеры сгорания, см³</translation>
    </message>
    <message>
        <source>Order spectrum of the moment</source>
        <translation>Спектр порядков момента</translation>
    </message>
    <message>
        <source>order (per turn of the crank)</source>
        <translation>порядок (за оборот вала)</translation>
    </message>
    <message>
        <source>Without a shaft</source>
        <translation>Без балансирного вала</translation>
    </message>
    <message>
        <source>With the shaft at the present α</source>
        <translation>С балансирным валом при текущем α</translation>
    </message>
    <message>
        <source>phase, °</source>
        <translation>фаза, °</translation>
    </message>
    <message>
        <source>Phase of the moment to the left: amplitude × sin(kφ + phase)</source>
        <translation>Фаза момента слева: амплитуда × sin(kφ + фаза)</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Порядок</translation>
    </message>
    <message>
        <source>Multiple of the crank speed</source>
        <translation>Кратность частоте вращения вала</translation>
    </message>
    <message>
        <source>Mᵤₚ, N·m</source>
        <translation>Mᵤₚ, Н·м</translation>
    </message>
    <message>
        <source>Fourier amplitude of the moment without a shaft</source>
        <translation>Амплитуда Фурье момента без вала</translation>
    </message>
    <message>
        <source>Mᵤₚₛ, N·m</source>
        <translation>Mᵤₚₛ, Н·м</translation>
    </message>
    <message>
        <source>Fourier amplitude with the shaft at the present α</source>
        <translation>Амплитуда Фурье с валом при текущем α</translation>
    </message>
    <message>
        <source>Excess energy over the cycle</source>
        <translation>Избыточная энергия за цикл</translation>
    </message>
    <message>
        <source>J</source>
        <translation>Дж</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>Work of the engine torque minus work of its mean</source>
        <translation>Работа крутящего момента за вычетом работы его среднего</translation>
    </message>
    <message>
        <source>fastest, %1 J</source>
        <translation>быстрее всего, %1 Дж</translation>
    </message>
    <message>
        <source>slowest, %1 J</source>
        <translation>медленнее всего, %1 Дж</translation>
    </message>
    <message>
        <source>Force on the engine</source>
        <translation>Сила на двигатель</translation>
    </message>
    <message>
        <source>across, kN</source>
        <translation>поперёк, кН</translation>
    </message>
    <message>
        <source>along, kN</source>
        <translation>вдоль, кН</translation>
    </message>
    <message>
        <source>without shaft, 1st + 2nd order</source>
        <translation>без вала, 1-й + 2-й порядок</translation>
    </message>
    <message>
        <source>First and second order without a shaft</source>
        <translation>Первый и второй порядок без балансирного вала</translation>
    </message>
    <message>
        <source>without shaft, 1st order</source>
        <translation>без вала, 1-й порядок</translation>
    </message>
    <message>
        <source>First order without a shaft: an ellipse</source>
        <translation>Первый порядок без балансирного вала: эллипс</translation>
    </message>
    <message>
        <source>with shaft</source>
        <translation>с валом</translation>
    </message>
    <message>
        <source>With the shaft the first order is a point; the second order along the cylinder remains</source>
        <translation>С валом первый порядок — точка; остаётся второй порядок вдоль цилиндра</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Сила</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Значение</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Ед.</translation>
    </message>
    <message>
        <source>on crank, κ mⱼ r</source>
        <translation>на кривошипе, κ mⱼ r</translation>
    </message>
    <message>
        <source>Static moment of the counterweight on the crank</source>
        <translation>Статический момент противовеса на коленчатом валу</translation>
    </message>
    <message>
        <source>Mᵤₚₛ with gear error</source>
        <translation>Mᵤₚₛ с ошибкой зацепления</translation>
    </message>
    <message>
        <source>play, low</source>
        <translation>зазор, низ</translation>
    </message>
    <message>
        <source>play</source>
        <translation>зазор</translation>
    </message>
    <message>
        <source>Band due to the play of the gears</source>
        <translation>Полоса из-за зазора в зацеплении</translation>
    </message>
    <message>
        <source>correct</source>
        <translation>верно</translation>
    </message>
    <message>
        <source>Correct timing</source>
        <translation>Верная установка</translation>
    </message>
    <message>
        <source>k teeth out</source>
        <translation>сдвиг k</translation>
    </message>
    <message>
        <source>Shaft k teeth out</source>
        <translation>Вал сдвинут на k зубьев</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>Шестерни</translation>
    </message>
    <message>
        <source>phase error</source>
        <translation>ошибка фазы</translation>
    </message>
    <message>
        <source>360° k / z</source>
        <translation>360° k / z</translation>
    </message>
    <message>
        <source>ΔMᵤₚₛ, correct timing → k teeth out</source>
        <translation>ΔMᵤₚₛ, верная установка → сдвиг на k зубьев</translation>
    </message>
    <message>
        <source>RMS of Mᵤₚₛ, correct timing → k teeth out</source>
        <translation>СКЗ Mᵤₚₛ, верная установка → сдвиг на k зубьев</translation>
    </message>
    <message>
        <source>play, ±</source>
        <translation>зазор, ±</translation>
    </message>
    <message>
        <source>Angle of the shaft within the play, to either side: play / l</source>
        <translation>Угол вала в пределах зазора, в каждую сторону: зазор / l</translation>
    </message>
    <message>
        <source>range in play</source>
        <translation>размах с зазором</translation>
    </message>
    <message>
        <source>Minimum and maximum ΔMᵤₚₛ within the play</source>
        <translation>Минимум и максимум ΔMᵤₚₛ в пределах зазора</translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation>Вал</translation>
    </message>
    <message>
        <source>Feasible.</source>
        <translation>Осуществимо.</translation>
    </message>
    <message>
        <source>φ, °</source>
        <translation>φ, °</translation>
    </message>
    <message>
        <source>Change in range vs. no shaft, %</source>
        <translation>Изменение размаха относительно схемы без вала, %</translation>
    </message>
    <message>
        <source>Change in RMS vs. no shaft, %</source>
        <translation>Изменение СКЗ относительно схемы без вала, %</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
</context>
<context>
    <name>ravnoves::ShaftRow</name>
    <message>
        <source>Shaft %1</source>
        <translation>Вал %1</translation>
    </message>
    <message>
        <source>Remove this shaft</source>
        <translation>Удалить этот вал</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Удалить: %1</translation>
    </message>
    <message>
        <source>Shaft %1: %2</source>
        <translation>Вал %1: %2</translation>
    </message>
</context>
<context>
    <name>ravnoves::ShaftTabs</name>
    <message>
        <source>Design</source>
        <translation>Подбор</translation>
    </message>
    <message>
        <source>Moments</source>
        <translation>Моменты</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Карта</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Частота</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Габарит</translation>
    </message>
    <message>
        <source>Analysis</source>
        <translation>Анализ</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Цикл</translation>
    </message>
    <message>
        <source>Orders</source>
        <translation>Порядки</translation>
    </message>
    <message>
        <source>Flywheel</source>
        <translation>Маховик</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Силы</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Деталь</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Лыска</translation>
    </message>
    <message>
        <source>The torque is a table. A pressure trace or a computed cycle shows gas and inertia torque, pressure and indicator diagram.</source>
        <translation>Крутящий момент задан таблицей. Индикаторная диаграмма или расчётный цикл показывают моменты сил газов и инерции, давление и диаграмму p–V.</translation>
    </message>
    <message>
        <source>&amp;Compute a cycle of the same load</source>
        <translation>&amp;Рассчитать цикл той же нагрузки</translation>
    </message>
    <message>
        <source>Work, pressures and power of the cycle</source>
        <translation>Работа, давления и мощность цикла</translation>
    </message>
    <message>
        <source>Size of the box around cylinder, crank and shaft circles, gears and wall; click a chart to set α.</source>
        <translation>Габарит вокруг цилиндра, окружностей кривошипа и вала, шестерён и стенки; щелчок по графику задаёт α.</translation>
    </message>
    <message>
        <source>A shaft at crank speed changes only order 1; the RMS is minimal where the shaft opposes it.</source>
        <translation>Вал, вращающийся со скоростью коленчатого, меняет только порядок 1; СКЗ минимально, где вал ему противоположен.</translation>
    </message>
    <message>
        <source>Order spectrum</source>
        <translation>Спектр порядков</translation>
    </message>
    <message>
        <source>Excess work, fluctuation and moment of inertia</source>
        <translation>Избыточная работа, неравномерность и момент инерции</translation>
    </message>
    <message>
        <source>The load equals the mean torque; J excludes piston and rod, whose inertia is part of the torque.</source>
        <translation>Нагрузка равна среднему моменту; J не включает поршень и шатун, их инерция входит в момент.</translation>
    </message>
    <message>
        <source>Balanced on the crank alone</source>
        <translation>Уравновешено только кривошипом</translation>
    </message>
    <message>
        <source>Forces with and without a shaft</source>
        <translation>Силы с валом и без вала</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>Шестерни</translation>
    </message>
    <message>
        <source>Effect of gear error and play</source>
        <translation>Действие ошибки зацепления и зазора</translation>
    </message>
    <message>
        <source>range</source>
        <translation>размах</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>СКЗ</translation>
    </message>
    <message>
        <source>&amp;Map of</source>
        <translation>&amp;Карта</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Применить</translation>
    </message>
    <message>
        <source>Apply the best compromise α</source>
        <translation>Применить лучший компромисс α</translation>
    </message>
    <message>
        <source>Criterion of the map and of the best compromise α</source>
        <translation>Критерий карты и лучшего компромисса α</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Ход работы</translation>
    </message>
    <message>
        <source>Shaft with a relieved middle</source>
        <translation>Вал с лыской в средней части</translation>
    </message>
    <message>
        <source>E&amp;xport drawing (DXF)…</source>
        <translation>&amp;Чертёж (DXF)…</translation>
    </message>
    <message>
        <source>Section and side view, real size, for the machine shop</source>
        <translation>Сечение и вид сбоку в натуральную величину, для цеха</translation>
    </message>
    <message>
        <source>Sizes and masses of the shaft</source>
        <translation>Размеры и массы вала</translation>
    </message>
    <message>
        <source>Export drawing</source>
        <translation>Запись чертежа</translation>
    </message>
    <message>
        <source>Enter two sizes; the third follows from the unbalance m₁ ρ₁.</source>
        <translation>Введите два размера; третий следует из дисбаланса m₁ ρ₁.</translation>
    </message>
</context>
<context>
    <name>ravnoves::ShopDialog</name>
    <message>
        <source>Shop on the job card</source>
        <translation>Мастерская на карте</translation>
    </message>
    <message>
        <source>&amp;Name of the shop</source>
        <translation>&amp;Название мастерской</translation>
    </message>
</context>
<context>
    <name>ravnoves::SpeedMapPlot</name>
    <message>
        <source>α, °</source>
        <translation>α, °</translation>
    </message>
    <message>
        <source>n, min⁻¹</source>
        <translation>n, мин⁻¹</translation>
    </message>
    <message>
        <source>%1 % worse</source>
        <translation>на %1&#xa0;% хуже</translation>
    </message>
    <message>
        <source>%1 % better</source>
        <translation>на %1&#xa0;% лучше</translation>
    </message>
    <message>
        <source>α %1°, n %2: %3</source>
        <translation>α %1°, n %2: %3</translation>
    </message>
    <message>
        <source>Blue: smaller with the shaft; orange: larger; thick line: no change; shaded: does not fit. Click to set α and, with a computed torque, the speed.</source>
        <translation>Синее: с валом меньше; оранжевое: больше; толстая линия: без изменений; затенено: не помещается. Щелчок задаёт α, а при вычисленном моменте и частоту.</translation>
    </message>
</context>
<context>
    <name>ravnoves::SpeedStudyModel</name>
    <message>
        <source>Speed band</source>
        <translation>Диапазон частот</translation>
    </message>
    <message>
        <source>range</source>
        <translation>размах</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>СКЗ</translation>
    </message>
    <message>
        <source>larger</source>
        <translation>больше</translation>
    </message>
    <message>
        <source>smaller</source>
        <translation>меньше</translation>
    </message>
    <message>
        <source>Rebuild the torque here, or choose a pressure trace or a computed cycle on the Torque tab.</source>
        <translation>Пересчитайте момент здесь или выберите давление или расчётный цикл на вкладке «Момент».</translation>
    </message>
    <message>
        <source>Choose a pressure trace or a computed cycle on the Torque tab.</source>
        <translation>Выберите давление или расчётный цикл на вкладке «Момент».</translation>
    </message>
    <message>
        <source>Cancelled. Change an input to solve again.</source>
        <translation>Отменено. Измените данные, чтобы решить снова.</translation>
    </message>
    <message>
        <source> No position is feasible.</source>
        <translation> Допустимых положений нет.</translation>
    </message>
    <message>
        <source> %1° would gain %2 % more but does not fit.</source>
        <translation> %1° дал бы ещё %2&#xa0;%, но не помещается.</translation>
    </message>
    <message>
        <source>Best compromise α over the band, by %1 vs. no shaft: %2°. At the worst speed, %3, the %1 is %4 % %5.</source>
        <translation>Лучший компромисс α в диапазоне (%1 относительно схемы без вала): %2°. При худшей частоте, %3, %1 на %4&#xa0;% %5.</translation>
    </message>
    <message>
        <source>The gas torque at every speed is from one pressure trace.</source>
        <translation>Момент газов при любой частоте взят из одной записи давления.</translation>
    </message>
    <message>
        <source>The load is constant over the speed.</source>
        <translation>Нагрузка при любой частоте одинакова.</translation>
    </message>
    <message>
        <source>The gas torque at every speed is from the given torque.</source>
        <translation>Момент газов при любой частоте — из заданного момента.</translation>
    </message>
</context>
<context>
    <name>ravnoves::StartPage</name>
    <message>
        <source>Files</source>
        <translation>Файлы</translation>
    </message>
    <message>
        <source>Open a case…</source>
        <translation>Открыть задачу…</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Примеры</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Работы</translation>
    </message>
    <message>
        <source>Journal…</source>
        <translation>Журнал…</translation>
    </message>
    <message>
        <source>unfinished</source>
        <translation>не закончена</translation>
    </message>
    <message>
        <source>What do you want to balance?</source>
        <translation>Что уравновешиваем?</translation>
    </message>
    <message>
        <source>Ravnoves computes the inertia forces of an engine and shows what a balance shaft, a bob weight or a drilled hole changes: for engine designers, balancing shops and students.</source>
        <translation>Ravnoves вычисляет силы инерции двигателя и показывает, что меняют балансирный вал, балансировочный груз или высверленное отверстие: для конструкторов двигателей, балансировочных мастерских и студентов.</translation>
    </message>
</context>
<context>
    <name>ravnoves::StudyModel</name>
    <message>
        <source>Tolerance</source>
        <translation>Допуск</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Допуски</translation>
    </message>
    <message>
        <source>Watch a result</source>
        <translation>Наблюдать результат</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Пределы</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Метод</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Выборка</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>«%1»</translation>
    </message>
    <message>
        <source>This case lists values of its inputs. The command line computes the table: ravnoves-cli study.</source>
        <translation>В этой задаче перечислены значения величин. Таблицу вычисляет командная строка: ravnoves-cli study.</translation>
    </message>
    <message>
        <source>To use tolerances here, undo or clear the study by “Typical tolerances”, “Remove all”.</source>
        <translation>Чтобы использовать допуски здесь, отмените изменение или очистите исследование: «Типовые допуски», «Удалить все».</translation>
    </message>
    <message>
        <source>“%1” is not a tolerance. Examples: 0.02, 1 %, σ 0.01.</source>
        <translation>«%1» — не допуск. Примеры: 0,02, 1&#xa0;%, σ 0,01.</translation>
    </message>
    <message>
        <source>%1 is not a limit: enter a number, or leave it blank.</source>
        <translation>%1 — не предел: введите число или оставьте пустым.</translation>
    </message>
    <message>
        <source>The lower limit is above the upper limit: across 0° enter %1 instead of %2.</source>
        <translation>Нижний предел выше верхнего: через 0° введите %1 вместо %2.</translation>
    </message>
    <message>
        <source>The lower limit is above the upper limit.</source>
        <translation>Нижний предел выше верхнего.</translation>
    </message>
    <message>
        <source>%1 (no longer in the case)</source>
        <translation>%1 (в задаче больше нет)</translation>
    </message>
    <message>
        <source>Feasible samples: %1</source>
        <translation>Допустимых проб: %1</translation>
    </message>
</context>
<context>
    <name>ravnoves::StudyTable</name>
    <message>
        <source>Not pasted. %1</source>
        <translation>Не вставлено. %1</translation>
    </message>
</context>
<context>
    <name>ravnoves::SweepModel</name>
    <message>
        <source>Minimum 95th percentile</source>
        <translation>Минимум 95-го процентиля</translation>
    </message>
    <message>
        <source>“From” must be less than “to”.</source>
        <translation>«От» должно быть меньше «до».</translation>
    </message>
</context>
<context>
    <name>ravnoves::SweepView</name>
    <message>
        <source>&amp;Input</source>
        <translation>&amp;Величина</translation>
    </message>
    <message>
        <source>&amp;Result</source>
        <translation>&amp;Результат</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Ход работы</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Вычисляется…</translation>
    </message>
    <message>
        <source>Choose a result to watch.</source>
        <translation>Выберите результат для наблюдения.</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>не менее</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>не более</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>среднее</translation>
    </message>
    <message>
        <source>Set t&amp;o %1</source>
        <translation>За&amp;дать %1</translation>
    </message>
    <message>
        <source>feasible</source>
        <translation>допустимо</translation>
    </message>
    <message>
        <source>Share of feasible samples.</source>
        <translation>Доля допустимых проб.</translation>
    </message>
    <message>
        <source>No value makes 95 % of the samples feasible.</source>
        <translation>Ни одно значение не даёт 95 % допустимых проб.</translation>
    </message>
    <message>
        <source>Rejected samples: %1.</source>
        <translation>Не принято проб: %1.</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>не принято</translation>
    </message>
    <message>
        <source>share of the samples, %</source>
        <translation>доля проб, %</translation>
    </message>
    <message>
        <source>feasible, %</source>
        <translation>допустимо, %</translation>
    </message>
    <message>
        <source>Blank: limit of the tolerance; without a tolerance, the value ± 10 %.</source>
        <translation>Пусто: граница допуска; без допуска — значение ± 10&#xa0;%.</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;От</translation>
    </message>
    <message>
        <source>t&amp;o</source>
        <translation>&amp;до</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>авто</translation>
    </message>
    <message>
        <source>Minimum 95th percentile of the absolute value: %1 at %2; %3 of the samples are feasible.</source>
        <translation>Минимум 95-го процентиля модуля: %1 при %2; допустимо %3 проб.</translation>
    </message>
    <message>
        <source>This is an end of the range.</source>
        <translation>Это граница диапазона.</translation>
    </message>
</context>
<context>
    <name>ravnoves::TableEditor</name>
    <message>
        <source>Copy (Ctrl+C)</source>
        <translation>Копировать (Ctrl+C)</translation>
    </message>
    <message>
        <source>Not pasted: “%1” has a comma, “%2” a point. Use one decimal sign and no thousands separators.</source>
        <translation>Не вставлено: в «%1» запятая, в «%2» точка. Десятичный знак должен быть один, без разделителей тысяч.</translation>
    </message>
    <message>
        <source>The clipboard contains no numbers.</source>
        <translation>В буфере обмена нет чисел.</translation>
    </message>
</context>
<context>
    <name>ravnoves::ToleranceBands</name>
    <message>
        <source>Half of the range from 5 % to 95 % of %1 samples of the tolerances; both sides where they differ.</source>
        <translation>Половина диапазона от 5 % до 95 % по %1 пробам допусков; обе стороны, если они различаются.</translation>
    </message>
    <message>
        <source>Half of the range from 5 % to 95 % of %1 samples of the uncertain dead centre of the trace; both sides where they differ.</source>
        <translation>Половина диапазона от 5 % до 95 % по %1 пробам неточной мёртвой точки диаграммы; обе стороны, если они различаются.</translation>
    </message>
    <message>
        <source>Includes the uncertain dead centre of the trace.</source>
        <translation>Учтена и неточность мёртвой точки диаграммы.</translation>
    </message>
</context>
<context>
    <name>ravnoves::ToleranceWindow</name>
    <message>
        <source>Tolerances</source>
        <translation>Допуски</translation>
    </message>
    <message>
        <source>Inputs and their tolerances</source>
        <translation>Исходные данные и допуски</translation>
    </message>
    <message>
        <source>&amp;All inputs: ± 1 %</source>
        <translation>Вс&amp;е величины: ±&#xa0;1&#xa0;%</translation>
    </message>
    <message>
        <source>Results to watch</source>
        <translation>Наблюдаемые результаты</translation>
    </message>
    <message>
        <source>M&amp;ethod</source>
        <translation>&amp;Метод</translation>
    </message>
    <message>
        <source>&amp;Samples</source>
        <translation>&amp;Выборка</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Ход работы</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Результат</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Номинал</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Среднее</translation>
    </message>
    <message>
        <source>σ, linear</source>
        <translation>σ, линейно</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>В пределах</translation>
    </message>
    <message>
        <source>Standard deviation of the samples.</source>
        <translation>Стандартное отклонение выборки.</translation>
    </message>
    <message>
        <source>Share of the samples within the limits, with its 95 % interval.</source>
        <translation>Доля выборки в пределах, с её 95-процентным интервалом.</translation>
    </message>
    <message>
        <source>share of the samples, %</source>
        <translation>доля проб, %</translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation>Гистограмма</translation>
    </message>
    <message>
        <source>Watch a result…</source>
        <translation>Наблюдать результат…</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Вычисляется…</translation>
    </message>
    <message>
        <source>Samples solved: %1</source>
        <translation>Решено проб: %1</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>номинал</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Вариация</translation>
    </message>
    <message>
        <source>Show &amp;bands and ± on the page</source>
        <translation>Показывать полосы и ± на страни&amp;це</translation>
    </message>
    <message>
        <source>share</source>
        <translation>доля</translation>
    </message>
    <message>
        <source>&amp;Weighed parts: ± %1, machined sizes: ± %2</source>
        <translation>&amp;Взвешенные детали: ±&#xa0;%1, обработанные размеры: ±&#xa0;%2</translation>
    </message>
    <message>
        <source>&amp;Typical tolerances</source>
        <translation>&amp;Типовые допуски</translation>
    </message>
    <message>
        <source>Remove the tolerances of the selected inputs</source>
        <translation>Удалить допуски выбранных величин</translation>
    </message>
    <message>
        <source>Remove the selected results</source>
        <translation>Удалить выбранные результаты</translation>
    </message>
    <message>
        <source>Results with tolerances</source>
        <translation>Результаты с допусками</translation>
    </message>
    <message>
        <source>Without tolerances.</source>
        <translation>Без допусков.</translation>
    </message>
    <message>
        <source>Main contributors</source>
        <translation>Главные вклады</translation>
    </message>
    <message>
        <source>Enter the tolerance of an input in the column ±, or choose typical tolerances.</source>
        <translation>Введите допуск величины в столбец ± или выберите типовые допуски.</translation>
    </message>
    <message>
        <source>Out of date: these tolerances were not accepted: %1.</source>
        <translation>Результат устарел: не приняты допуски: %1.</translation>
    </message>
    <message>
        <source>The method of this case, %1, is no longer available. Sobol points are used; tolerances and limits are kept.</source>
        <translation>Метода этой задачи (%1) больше нет. Используются точки Соболя; допуски и пределы сохранены.</translation>
    </message>
    <message>
        <source>Values before the change; computing…</source>
        <translation>Значения до изменения; вычисляется…</translation>
    </message>
    <message>
        <source>Rejected: %1 × %2</source>
        <translation>Не принято: %1 × %2</translation>
    </message>
    <message>
        <source>second order</source>
        <translation>второго порядка</translation>
    </message>
    <message>
        <source>Latin hypercube</source>
        <translation>латинский гиперкуб</translation>
    </message>
    <message>
        <source>&amp;Remove all</source>
        <translation>&amp;Удалить все</translation>
    </message>
    <message>
        <source>Mean of all solved samples.</source>
        <translation>Среднее по всем решённым пробам.</translation>
    </message>
    <message>
        <source>Standard deviation by the slopes at the nominal values.</source>
        <translation>Стандартное отклонение только по наклонам при номинальных значениях.</translation>
    </message>
    <message>
        <source>5 % of the samples are smaller.</source>
        <translation>Меньше — 5&#xa0;% проб.</translation>
    </message>
    <message>
        <source>5 % of the samples are larger.</source>
        <translation>Больше — 5&#xa0;% проб.</translation>
    </message>
    <message>
        <source>Choose a result to watch.</source>
        <translation>Выберите результат для наблюдения.</translation>
    </message>
</context>
<context>
    <name>ravnoves::TornadoView</name>
    <message>
        <source>alone, %</source>
        <translation>сам по себе, %</translation>
    </message>
    <message>
        <source>with others, %</source>
        <translation>вместе с другими, %</translation>
    </message>
    <message>
        <source>Shares of the variance of %1</source>
        <translation>Доли дисперсии: %1</translation>
    </message>
    <message>
        <source>Dark: share of the variance of an input alone (Sobol&apos;s first-order index). Light: further share with other inputs (total index).</source>
        <translation>Тёмное: доля дисперсии одной величины (индекс Соболя первого порядка). Светлое: ещё вместе с другими (полный индекс).</translation>
    </message>
</context>
<context>
    <name>ravnoves::TorqueSourceEditor</name>
    <message>
        <source>table</source>
        <translation>таблица</translation>
    </message>
    <message>
        <source>pressure trace</source>
        <translation>давление</translation>
    </message>
    <message>
        <source>computed cycle</source>
        <translation>расчётный цикл</translation>
    </message>
    <message>
        <source>Tor&amp;que from</source>
        <translation>Источник &amp;момента</translation>
    </message>
    <message>
        <source>Use its speed</source>
        <translation>Применить эту частоту</translation>
    </message>
    <message>
        <source>Rebuild torque</source>
        <translation>Пересчитать</translation>
    </message>
    <message>
        <source>Use the torque&apos;s speed</source>
        <translation>Применить частоту момента</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Цилиндр</translation>
    </message>
    <message>
        <source>Gas exchange and compression</source>
        <translation>Газообмен и сжатие</translation>
    </message>
    <message>
        <source>Combustion</source>
        <translation>Сгорание</translation>
    </message>
    <message>
        <source>A plain cycle: constant pressures for gas exchange, polytropic compression, one Wiebe heat release, polytropic expansion.</source>
        <translation>Простой цикл: постоянные давления газообмена, политропное сжатие, одно тепловыделение по Вибе, политропное расширение.</translation>
    </message>
    <message>
        <source>Impo&amp;rt file…</source>
        <translation>Импорт фай&amp;ла…</translation>
    </message>
    <message>
        <source>Import pressure trace</source>
        <translation>Импорт индикаторной диаграммы</translation>
    </message>
    <message>
        <source>Pressure trace</source>
        <translation>Индикаторная диаграмма</translation>
    </message>
    <message>
        <source>A table is used as entered. A pressure trace or computed cycle gives gas torque plus inertia torque of the masses and speed.</source>
        <translation>Таблица берётся как есть. Диаграмма или расчётный цикл даёт газовый момент плюс инерционный по массам и частоте.</translation>
    </message>
    <message>
        <source>No table yet, so the computed torque is used: paste a table, import a CSV file, or use this torque as table.</source>
        <translation>Таблицы ещё нет, поэтому используется вычисленный момент: вставьте таблицу, импортируйте CSV или сделайте таблицу из этого момента.</translation>
    </message>
    <message>
        <source>Use as table</source>
        <translation>Сделать таблицей</translation>
    </message>
    <message>
        <source>Make a table of the computed torque, a row per step. The table does not follow speed and masses.</source>
        <translation>Составить таблицу вычисленного момента, строка на шаг. Таблица не зависит от частоты и масс.</translation>
    </message>
    <message>
        <source>Set the speed at which the masses give the inertia torque of the table.</source>
        <translation>Задать частоту, при которой массы дают инерционный момент таблицы.</translation>
    </message>
    <message>
        <source>Replace the fitted inertia torque of the table by the inertia torque of masses and speed.</source>
        <translation>Заменить подобранный инерционный момент таблицы моментом по массам и частоте.</translation>
    </message>
    <message>
        <source>Measured cylinder pressure over one or more cycles; crank angles start at the dead centre before intake (two-stroke: at firing).</source>
        <translation>Измеренное давление за один или несколько циклов; углы — от мёртвой точки перед впуском (двухтактный: от сгорания).</translation>
    </message>
    <message>
        <source>No pressure trace yet; the computed cycle is used.</source>
        <translation>Диаграммы ещё нет; используется расчётный цикл.</translation>
    </message>
    <message>
        <source>No pressure trace yet; the table is used.</source>
        <translation>Диаграммы ещё нет; используется таблица.</translation>
    </message>
    <message>
        <source>%1 cannot be read; import it again from its new place.</source>
        <translation>%1 не читается; импортируйте его из нового места.</translation>
    </message>
    <message>
        <source>Pressure trace: %1.</source>
        <translation>Диаграмма: %1.</translation>
    </message>
</context>
<context>
    <name>ravnoves::TorqueTableEditor</name>
    <message>
        <source>Import CSV file…</source>
        <translation>Прочитать CSV…</translation>
    </message>
    <message>
        <source>Import torque table</source>
        <translation>Чтение таблицы момента</translation>
    </message>
    <message>
        <source>Export CSV file…</source>
        <translation>Записать CSV…</translation>
    </message>
    <message>
        <source>Export torque table</source>
        <translation>Запись таблицы момента</translation>
    </message>
    <message>
        <source>Insert a row below</source>
        <translation>Вставить строку ниже</translation>
    </message>
    <message>
        <source>Delete the selected rows</source>
        <translation>Удалить выбранные строки</translation>
    </message>
    <message>
        <source>Torque table</source>
        <translation>Таблица момента</translation>
    </message>
    <message>
        <source>Read %1.</source>
        <translation>Прочитано: %1.</translation>
    </message>
    <message>
        <source>Not pasted: %1</source>
        <translation>Не вставлено: %1</translation>
    </message>
    <message>
        <source>Paste (Ctrl+V)</source>
        <translation>Вставить (Ctrl+V)</translation>
    </message>
    <message>
        <source>Engine torque over one cycle, 720° (two-stroke 360°). Paste a whole table from a spreadsheet, or type.</source>
        <translation>Крутящий момент за один цикл, 720° (двухтактный — 360°). Вставьте всю таблицу из электронной таблицы или введите.</translation>
    </message>
    <message>
        <source>The previous value is used until this is corrected.</source>
        <translation>Пока это не исправлено, используется прежнее значение.</translation>
    </message>
</context>
<context>
    <name>ravnoves::TorqueTableModel</name>
    <message>
        <source>φ, °</source>
        <translation>φ, °</translation>
    </message>
    <message>
        <source>torque, N·m</source>
        <translation>момент, Н·м</translation>
    </message>
    <message>
        <source>Row %1: %2</source>
        <translation>Строка %1: %2</translation>
    </message>
    <message>
        <source>with %1° the angles do not span 720° (two-stroke: 360°).</source>
        <translation>с %1° углы не охватывают 720° (у двухтактного 360°).</translation>
    </message>
    <message>
        <source>the first and the last torque must be equal (same instant of the cycle).</source>
        <translation>первый и последний моменты должны быть равны (одно мгновение цикла).</translation>
    </message>
    <message>
        <source>%1° is out of order: the angles must ascend.</source>
        <translation>%1° не по порядку: углы должны возрастать.</translation>
    </message>
    <message>
        <source>Edit torque table</source>
        <translation>Правка таблицы момента</translation>
    </message>
    <message>
        <source>The table covers 360°: the four-stroke engine is now a two-stroke. Undo restores it.</source>
        <translation>Таблица охватывает 360°: четырёхтактный двигатель стал двухтактным. Отмена вернёт прежний.</translation>
    </message>
    <message>
        <source>The table covers 720°: the two-stroke engine is now a four-stroke. Undo restores it.</source>
        <translation>Таблица охватывает 720°: двухтактный двигатель стал четырёхтактным. Отмена вернёт прежний.</translation>
    </message>
</context>
<context>
    <name>ravnoves::ValidationModel</name>
    <message>
        <source>Place</source>
        <translation>Место</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Величина</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Ед.</translation>
    </message>
    <message>
        <source>Printed</source>
        <translation>В статье</translation>
    </message>
    <message>
        <source>Ours</source>
        <translation>У нас</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Разность</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Вывод</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>вычисляется…</translation>
    </message>
    <message>
        <source>Printed numbers: %1 – %2</source>
        <translation>Напечатанных чисел: %1 — %2</translation>
    </message>
    <message>
        <source>Where the paper prints the number</source>
        <translation>Где число напечатано в статье</translation>
    </message>
    <message>
        <source>Choose a row to read why</source>
        <translation>Выберите строку, чтобы прочесть, почему</translation>
    </message>
</context>
<context>
    <name>ravnoves::ValidationView</name>
    <message>
        <source>Paper</source>
        <translation>Статья</translation>
    </message>
    <message>
        <source>Show the numbers of one paper only</source>
        <translation>Показать числа только одной статьи</translation>
    </message>
    <message>
        <source>All papers</source>
        <translation>Все статьи</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Вывод</translation>
    </message>
    <message>
        <source>Show the numbers with one verdict only</source>
        <translation>Показать числа только с одним выводом</translation>
    </message>
    <message>
        <source>All verdicts</source>
        <translation>Все выводы</translation>
    </message>
    <message>
        <source>Copy as CS&amp;V</source>
        <translation>Копировать как CS&amp;V</translation>
    </message>
    <message>
        <source>Copy the rows shown as CSV, numbers in full precision</source>
        <translation>Скопировать показанные строки как CSV, числа с полной точностью</translation>
    </message>
    <message>
        <source>Report copied as CSV</source>
        <translation>Отчёт скопирован как CSV</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>&amp;Статья</translation>
    </message>
    <message>
        <source>Ver&amp;dict</source>
        <translation>В&amp;ывод</translation>
    </message>
    <message>
        <source>Printed numbers and our values</source>
        <translation>Напечатанные и наши числа</translation>
    </message>
    <message>
        <source>Select a row to read the reason of its verdict.</source>
        <translation>Выберите строку, чтобы прочесть причину вывода.</translation>
    </message>
</context>
<context>
    <name>ravnoves::VariantMenu</name>
    <message>
        <source>&amp;Variants</source>
        <translation>Вар&amp;ианты</translation>
    </message>
    <message>
        <source>&amp;Keep as reference</source>
        <translation>&amp;Сохранить как эталон</translation>
    </message>
    <message>
        <source>&amp;No reference</source>
        <translation>&amp;Без эталона</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Переименовать…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Удалить</translation>
    </message>
    <message>
        <source>This page has no inputs to keep as variants.</source>
        <translation>На этой странице нет данных, чтобы сохранять варианты.</translation>
    </message>
    <message>
        <source>Variants: the reference is %1</source>
        <translation>Варианты: эталон — %1</translation>
    </message>
    <message>
        <source>Rename variant</source>
        <translation>Переименование варианта</translation>
    </message>
    <message>
        <source>Name of the variant</source>
        <translation>Имя варианта</translation>
    </message>
    <message>
        <source>Variants</source>
        <translation>Варианты</translation>
    </message>
    <message>
        <source>Keeps the present input as a variant; later changes are compared with it</source>
        <translation>Сохраняет текущие данные как вариант; дальнейшие изменения сравниваются с ним</translation>
    </message>
    <message>
        <source>Shows the present input alone; variants are kept</source>
        <translation>Показывает только текущие данные; варианты сохраняются</translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation>При&amp;менить</translation>
    </message>
    <message>
        <source>The reference becomes the present input and remains the reference</source>
        <translation>Эталон становится текущими данными и остаётся эталоном</translation>
    </message>
    <message>
        <source>Renames the reference</source>
        <translation>Переименовывает эталон</translation>
    </message>
    <message>
        <source>Removes the reference from the case</source>
        <translation>Убирает эталон из задачи</translation>
    </message>
    <message>
        <source>Variants: keep the present input as reference (Ctrl+K); later changes are compared with it</source>
        <translation>Варианты: сохраните текущие данные как эталон (Ctrl+K); дальнейшие изменения сравниваются с ним</translation>
    </message>
    <message>
        <source>&amp;Compare side by side…</source>
        <translation>С&amp;равнить варианты…</translation>
    </message>
    <message>
        <source>Shows the differences between the present input and all variants, then their results</source>
        <translation>Показывает, чем отличаются текущие данные и все варианты, затем их результаты</translation>
    </message>
    <message>
        <source>Compare the present input with %1</source>
        <translation>Сравнить текущие данные с %1</translation>
    </message>
    <message>
        <source>Kept as variant %1; later changes are compared with it.</source>
        <translation>Сохранено как вариант %1; дальнейшие изменения сравниваются с ним.</translation>
    </message>
</context>
<context>
    <name>ravnoves::VariantTable</name>
    <message>
        <source>Variants side by side</source>
        <translation>Сравнение вариантов</translation>
    </message>
    <message>
        <source>&amp;Save as CSV…</source>
        <translation>&amp;Сохранить как CSV…</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Результат</translation>
    </message>
    <message>
        <source>Present</source>
        <translation>Сейчас</translation>
    </message>
    <message>
        <source>%1 (reference)</source>
        <translation>%1 (эталон)</translation>
    </message>
    <message>
        <source>An input that differs.</source>
        <translation>Отличающаяся исходная величина.</translation>
    </message>
    <message>
        <source>★ marks the best of those without a warning.</source>
        <translation>★ отмечает лучшее из вариантов без предупреждений.</translation>
    </message>
    <message>
        <source>No variants yet. Press Ctrl+K to keep the present input as a variant.</source>
        <translation>Вариантов ещё нет. Ctrl+K сохраняет текущие данные как вариант.</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Компоновка</translation>
    </message>
</context>
<context>
    <name>ravnoves::VerdictLine</name>
    <message>
        <source>OK</source>
        <translation>В порядке</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Предупреждение</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Ошибка</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Примечание</translation>
    </message>
</context>
<context>
    <name>ravnoves::WatchTable</name>
    <message>
        <source>Result</source>
        <translation>Результат</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Минимум</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Максимум</translation>
    </message>
</context>
<context>
    <name>ravnoves::WeighInSheet</name>
    <message>
        <source>In line each cylinder has a crankpin of its own.</source>
        <translation>В рядном двигателе у каждого цилиндра своя шатунная шейка.</translation>
    </message>
    <message>
        <source>The sheet shows %1 of %2 cylinders. Paste a column of a spreadsheet for all, or type the means on sheet 2.</source>
        <translation>На листе %1 из %2 цилиндров. Вставьте столбец из таблицы для всех или введите средние на листе 2.</translation>
    </message>
    <message>
        <source>Use the mass changes o&amp;f this sheet</source>
        <translation>Использовать изменения масс с &amp;этого листа</translation>
    </message>
    <message>
        <source>mean, g</source>
        <translation>среднее, г</translation>
    </message>
    <message>
        <source>vs. nominal, g</source>
        <translation>от номинала, г</translation>
    </message>
    <message>
        <source>&amp;Move them here</source>
        <translation>Пере&amp;ставить здесь</translation>
    </message>
    <message>
        <source>As &amp;weighed</source>
        <translation>Как &amp;взвешено</translation>
    </message>
    <message>
        <source>range, g</source>
        <translation>размах, г</translation>
    </message>
    <message>
        <source>Parts were moved by this rule: press “As weighed” to change the rule.</source>
        <translation>Детали переставлены по этому правилу: чтобы изменить его, нажмите «Как взвешено».</translation>
    </message>
    <message>
        <source>Moves the masses on this sheet with the parts.</source>
        <translation>Переставляет массы на этом листе вместе с деталями.</translation>
    </message>
    <message>
        <source>Returns the masses to the cylinders where they were weighed.</source>
        <translation>Возвращает массы к цилиндрам, где их взвесили.</translation>
    </message>
    <message>
        <source>Effect of the matching</source>
        <translation>Результат подбора</translation>
    </message>
    <message>
        <source>Sets by cylinder</source>
        <translation>Комплекты по цилиндрам</translation>
    </message>
    <message>
        <source>Mass to take off each part to match the lightest</source>
        <translation>Сколько снять с каждой детали до самой лёгкой</translation>
    </message>
    <message>
        <source>%1, nominal mass</source>
        <translation>%1, номинальная масса</translation>
    </message>
    <message>
        <source>%1 of cylinder %2</source>
        <translation>%1, цилиндр %2</translation>
    </message>
    <message>
        <source>%1: mass by the drawing.</source>
        <translation>%1: масса по чертежу.</translation>
    </message>
    <message>
        <source>nominal, g</source>
        <translation>номинал, г</translation>
    </message>
    <message>
        <source>%1, permitted range</source>
        <translation>%1, допустимый размах</translation>
    </message>
    <message>
        <source>%1: permitted heaviest minus lightest, by the works manual. Blank means no limit.</source>
        <translation>%1: допустимая разность самой тяжёлой и самой лёгкой по руководству. Пусто: без предела.</translation>
    </message>
    <message>
        <source>%1 of cylinder %2 by the scale.</source>
        <translation>%1, цилиндр %2, по весам.</translation>
    </message>
    <message>
        <source>permitted range, g</source>
        <translation>допустимый размах, г</translation>
    </message>
</context>
<context>
    <name>ravnoves::WorkshopAnswer</name>
    <message>
        <source>Plugs</source>
        <translation>Заглушки</translation>
    </message>
    <message>
        <source>The options</source>
        <translation>Варианты</translation>
    </message>
    <message>
        <source>Bob weight, line by line</source>
        <translation>Балансировочный груз по строкам</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Коррекция</translation>
    </message>
    <message>
        <source>Holes and slugs</source>
        <translation>Отверстия и вставки</translation>
    </message>
    <message>
        <source>The correction planes</source>
        <translation>Плоскости коррекции</translation>
    </message>
    <message>
        <source>Runs of the machine</source>
        <translation>Пуски станка</translation>
    </message>
    <message>
        <source>Already drilled</source>
        <translation>Уже просверлено</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Подробности</translation>
    </message>
    <message>
        <source>Charts that explain the bob weight or the plugs.</source>
        <translation>Графики, поясняющие балансировочный груз или заглушки.</translation>
    </message>
</context>
<context>
    <name>ravnoves::WorkshopModel</name>
    <message>
        <source>Entries not accepted</source>
        <translation>Непринятые значения</translation>
    </message>
    <message>
        <source>Parts as weighed</source>
        <translation>Детали как взвешены</translation>
    </message>
    <message>
        <source>Move parts</source>
        <translation>Перестановка деталей</translation>
    </message>
    <message>
        <source>By the limits of both planes</source>
        <translation>По допускам обеих плоскостей</translation>
    </message>
    <message>
        <source>Angle of the heavy spot from the machine&apos;s zero mark</source>
        <translation>Угол тяжёлого места от нулевой метки станка</translation>
    </message>
    <message>
        <source>By the limit of the plane: as measured → after the correction</source>
        <translation>По допуску плоскости: измерено → после коррекции</translation>
    </message>
    <message>
        <source>From the machine&apos;s zero mark</source>
        <translation>От нулевой метки станка</translation>
    </message>
    <message>
        <source>Only a V-8 at 90° with two rods on a crankpin has sludge-trap plugs. Untick them first.</source>
        <translation>Заглушки грязеуловителей бывают только у V-8 с углом 90° и двумя шатунами на шейке. Сначала снимите отметку.</translation>
    </message>
    <message>
        <source>Two rods share a bob weight, and %1 is odd. Choose one rod on a bob weight first.</source>
        <translation>На груз приходятся два шатуна, а %1 — нечётное число. Сначала выберите один шатун на груз.</translation>
    </message>
    <message>
        <source>Swap the columns</source>
        <translation>Поменять столбцы</translation>
    </message>
    <message>
        <source>Swap the rod’s ends</source>
        <translation>Поменять головки шатуна</translation>
    </message>
    <message>
        <source>Drill the holes and measure again.</source>
        <translation>Просверлите отверстия и измерьте снова.</translation>
    </message>
    <message>
        <source>Sludge-trap plugs</source>
        <translation>Заглушки грязеуловителей</translation>
    </message>
    <message>
        <source>Masses of the nominal parts</source>
        <translation>Массы номинальных деталей</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Двигатель</translation>
    </message>
    <message>
        <source>Excess Δmᵤ: %1, %2</source>
        <translation>Неуравновешенная масса Δmᵤ: %1, %2</translation>
    </message>
    <message>
        <source>A plug of these dimensions weighs %1 in steel, %2 in aluminium.</source>
        <translation>Заглушка таких размеров весит %1 из стали, %2 из алюминия.</translation>
    </message>
    <message>
        <source>Option</source>
        <translation>Вариант</translation>
    </message>
    <message>
        <source>The engine has no such plug, or its data are missing.</source>
        <translation>Такой заглушки у двигателя нет или нет её данных.</translation>
    </message>
    <message>
        <source>For the other crankshaft.</source>
        <translation>Для другого вала.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>fixed part, g</source>
        <translation>постоянная часть, г</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>коэффициент</translation>
    </message>
    <message>
        <source>maximum, g</source>
        <translation>предел, г</translation>
    </message>
    <message>
        <source>take off each, g</source>
        <translation>облегчить каждую, г</translation>
    </message>
    <message>
        <source>remains, g</source>
        <translation>остаток, г</translation>
    </message>
    <message>
        <source>Residual mass</source>
        <translation>Остаточная масса</translation>
    </message>
    <message>
        <source>remains, g·mm</source>
        <translation>остаток, г·мм</translation>
    </message>
    <message>
        <source>Residual unbalance, mass times crank radius</source>
        <translation>Остаточный дисбаланс, масса на радиус кривошипа</translation>
    </message>
    <message>
        <source>The take-off includes the shift; the method alone would leave up to %1.</source>
        <translation>Снимаемая масса учитывает смещение; один метод оставил бы до %1.</translation>
    </message>
    <message>
        <source>STOP: correct the top line before drilling.</source>
        <translation>СТОП: до сверления исправьте верхнюю строку.</translation>
    </message>
    <message>
        <source>Used when every cylinder is weighed.</source>
        <translation>Используется, когда взвешены все цилиндры.</translation>
    </message>
    <message>
        <source>Mass of the bob weight</source>
        <translation>Масса балансировочного груза</translation>
    </message>
    <message>
        <source>Multiplier of the mass in the bob weight: number of rods, times the balance factor for reciprocating parts</source>
        <translation>Множитель массы в грузе: число шатунов, для возвратно-поступательных частей ещё и коэффициент балансировки</translation>
    </message>
    <message>
        <source>Mass × multiplier</source>
        <translation>Масса × множитель</translation>
    </message>
    <message>
        <source>Both readings, transferred to the correction planes (same force, same moment)</source>
        <translation>Оба показания, перенесённые в плоскости коррекции (та же сила, тот же момент)</translation>
    </message>
    <message>
        <source>Mass at the drilling radius for this unbalance</source>
        <translation>Масса на радиусе сверления для этого дисбаланса</translation>
    </message>
    <message>
        <source>Residual after the holes below, with rounded depths</source>
        <translation>Остаток после отверстий ниже, с округлёнными глубинами</translation>
    </message>
    <message>
        <source>Readings are still valid</source>
        <translation>Показания верны</translation>
    </message>
    <message>
        <source>Enter the angles of the readings.</source>
        <translation>Введите углы показаний.</translation>
    </message>
    <message>
        <source>Enter the readings of both planes.</source>
        <translation>Введите показания обеих плоскостей.</translation>
    </message>
    <message>
        <source>Do not use: bob weight %1.</source>
        <translation>Не использовать: балансировочный груз %1.</translation>
    </message>
    <message>
        <source>The paper gives only the crank radius of this engine; measure the other values.</source>
        <translation>Для этого двигателя статья даёт только радиус кривошипа; остальное измерьте.</translation>
    </message>
    <message>
        <source>The paper&apos;s plug masses look too small for its threads: weigh the plugs and enter their masses.</source>
        <translation>Массы заглушек из статьи малы для её резьб: взвесьте заглушки и введите массы.</translation>
    </message>
    <message>
        <source>%1 in each plane, for this job only.</source>
        <translation>%1 в каждой плоскости — только для этой работы.</translation>
    </message>
    <message>
        <source>Enter thread and height to see the mass of the plug.</source>
        <translation>Введите резьбу и высоту, чтобы увидеть массу заглушки.</translation>
    </message>
    <message>
        <source>Option; ✓ sufficient, ✗ not sufficient, ! shift included</source>
        <translation>Вариант; ✓ достаточно, ✗ недостаточно, ! смещение учтено</translation>
    </message>
    <message>
        <source>Mass compensated without boring, kₚ times the mass difference of the plugs</source>
        <translation>Масса, компенсируемая без расточки, kₚ на разность масс заглушек</translation>
    </message>
    <message>
        <source>Mass compensated per gram taken off each plug</source>
        <translation>Масса, компенсируемая на грамм, снятый с каждой заглушки</translation>
    </message>
    <message>
        <source>Maximum mass that the option compensates</source>
        <translation>Максимальная масса, которую вариант компенсирует</translation>
    </message>
    <message>
        <source>Mass to take off each plug, as far as the plug allows it</source>
        <translation>Сколько снять с каждой заглушки, насколько она позволяет</translation>
    </message>
    <message>
        <source>%1: %2 weighed; heaviest in cylinder %3, lightest in cylinder %4.</source>
        <translation>%1: взвешено %2; тяжелее всех в цилиндре %3, легче всех в цилиндре %4.</translation>
    </message>
    <message>
        <source>Limit of this method: %1 in each plane, the residual of Nazarov&apos;s experiments.</source>
        <translation>Предел метода: %1 в каждой плоскости, остаток в опытах Назарова.</translation>
    </message>
    <message>
        <source>Shop limit: %1 in each plane.</source>
        <translation>Предел мастерской: %1 в каждой плоскости.</translation>
    </message>
    <message>
        <source>Mass taken off, including the drill point; a slug adds its own mass minus its hole</source>
        <translation>Снятая масса, включая конус; вставка добавляет свою массу минус отверстие</translation>
    </message>
    <message>
        <source>STOP: do not drill yet</source>
        <translation>СТОП: пока не сверлить</translation>
    </message>
    <message>
        <source>Enter the permissible residual.</source>
        <translation>Введите допустимый остаточный дисбаланс.</translation>
    </message>
    <message>
        <source>Readings of the run, transferred to this plane, as the machine shows them</source>
        <translation>Показания пуска, перенесённые в эту плоскость, как их даёт станок</translation>
    </message>
    <message>
        <source>Name of the engine</source>
        <translation>Название двигателя</translation>
    </message>
    <message>
        <source>Paste weights</source>
        <translation>Вставка масс</translation>
    </message>
    <message>
        <source>Not pasted: from here the block does not fit on the sheet of %1 cylinders.</source>
        <translation>Не вставлено: отсюда блок не помещается на лист, где цилиндров %1.</translation>
    </message>
    <message>
        <source>Not pasted: %1</source>
        <translation>Не вставлено: %1</translation>
    </message>
    <message>
        <source>Correct this first, or restore the value with Escape: %1</source>
        <translation>Сначала исправьте или верните значение клавишей Escape: %1</translation>
    </message>
    <message>
        <source>Not pasted: “%1” is not a mass in %2.</source>
        <translation>Не вставлено: «%1» — не масса в %2.</translation>
    </message>
    <message>
        <source>Plan printed or put aside</source>
        <translation>План напечатан или отложен</translation>
    </message>
    <message>
        <source>Use the present plan</source>
        <translation>Принять текущий план</translation>
    </message>
</context>
<context>
    <name>ravnoves::WorkshopPage</name>
    <message>
        <source>Entries were not accepted when the program ended. Enter or check them again: %1</source>
        <translation>Когда программа завершилась, были непринятые значения. Введите или проверьте их: %1</translation>
    </message>
    <message>
        <source>New job. Cleared: numbers, customer, typed and weighed masses, readings, holes and the crankshaft’s mass. Engine, machine, planes and drills are kept.</source>
        <translation>Новая работа. Очищены: номера, заказчик, введённые и взвешенные массы, показания, отверстия и масса вала. Двигатель, станок, плоскости и свёрла сохранены.</translation>
    </message>
    <message>
        <source>&amp;Save job in the journal</source>
        <translation>&amp;Сохранить работу в журнале</translation>
    </message>
    <message>
        <source>Save the job in the journal</source>
        <translation>Сохранить работу в журнале</translation>
    </message>
    <message>
        <source>Put job &amp;aside unfinished</source>
        <translation>О&amp;тложить незаконченную работу</translation>
    </message>
    <message>
        <source>&amp;Next job</source>
        <translation>С&amp;ледующая работа</translation>
    </message>
    <message>
        <source>&amp;Journal…</source>
        <translation>&amp;Журнал…</translation>
    </message>
    <message>
        <source>Find, open and copy jobs</source>
        <translation>Найти, открыть, скопировать работы</translation>
    </message>
    <message>
        <source>Job card, &amp;preview…</source>
        <translation>&amp;Просмотр карты…</translation>
    </message>
    <message>
        <source>&amp;Print job card…</source>
        <translation>П&amp;ечать карты…</translation>
    </message>
    <message>
        <source>Print the job card</source>
        <translation>Напечатать карту</translation>
    </message>
    <message>
        <source>Job card as P&amp;DF…</source>
        <translation>Карта в P&amp;DF…</translation>
    </message>
    <message>
        <source>Write the job card as PDF</source>
        <translation>Записать карту в PDF</translation>
    </message>
    <message>
        <source>S&amp;hop on the job card…</source>
        <translation>&amp;Мастерская на карте…</translation>
    </message>
    <message>
        <source>&amp;Back up the journal…</source>
        <translation>&amp;Резервная копия журнала…</translation>
    </message>
    <message>
        <source>&amp;Restore from a backup…</source>
        <translation>&amp;Восстановить из копии…</translation>
    </message>
    <message>
        <source>&amp;Language of the job card</source>
        <translation>&amp;Язык карты</translation>
    </message>
    <message>
        <source>As the program</source>
        <translation>Как в программе</translation>
    </message>
    <message>
        <source>Unsaved job</source>
        <translation>Несохранённая работа</translation>
    </message>
    <message>
        <source>Save the job on the sheet in the journal?</source>
        <translation>Сохранить работу с листа в журнале?</translation>
    </message>
    <message>
        <source>Do&amp;n’t save</source>
        <translation>&amp;Не сохранять</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Журнал</translation>
    </message>
    <message>
        <source>Back up the journal</source>
        <translation>Резервная копия журнала</translation>
    </message>
    <message>
        <source>Restore from a backup</source>
        <translation>Восстановление из копии</translation>
    </message>
    <message>
        <source>Journal (*.sqlite)</source>
        <translation>Журнал (*.sqlite)</translation>
    </message>
    <message>
        <source>Job card</source>
        <translation>Карта</translation>
    </message>
    <message>
        <source>The printer cannot be used.</source>
        <translation>Принтер недоступен.</translation>
    </message>
    <message>
        <source>Job card as PDF</source>
        <translation>Карта в PDF</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
    <message>
        <source>Save as a &amp;new job</source>
        <translation>Записать как &amp;новую работу</translation>
    </message>
    <message>
        <source>&amp;Change that job</source>
        <translation>&amp;Изменить ту работу</translation>
    </message>
    <message>
        <source>The job of %1 in the journal is for another engine than the sheet.</source>
        <translation>Работа %1 в журнале — для другого двигателя, чем на листе.</translation>
    </message>
    <message>
        <source>The journal already has a job of %1 on this day, saved on %2.</source>
        <translation>В журнале уже есть работа %1 за этот день, записанная %2.</translation>
    </message>
    <message>
        <source>&amp;Replace it</source>
        <translation>&amp;Заменить её</translation>
    </message>
    <message>
        <source>Save as &amp;another</source>
        <translation>Записать как &amp;другую</translation>
    </message>
    <message>
        <source>Save the job “%1” in the journal?</source>
        <translation>Сохранить работу «%1» в журнале?</translation>
    </message>
    <message>
        <source>&amp;Enter one</source>
        <translation>&amp;Ввести</translation>
    </message>
    <message>
        <source>Save &amp;without</source>
        <translation>Сохранить &amp;без них</translation>
    </message>
    <message>
        <source>Restoring %1…</source>
        <translation>Восстановление из %1…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>&amp;1 Job</source>
        <translation>&amp;1 Работа</translation>
    </message>
    <message>
        <source>&amp;2 Parts</source>
        <translation>&amp;2 Детали</translation>
    </message>
    <message>
        <source>&amp;3 Weigh-in</source>
        <translation>&amp;3 Взвешивание</translation>
    </message>
    <message>
        <source>&amp;4 Plugs</source>
        <translation>&amp;4 Заглушки</translation>
    </message>
    <message>
        <source>&amp;5 Machine</source>
        <translation>&amp;5 Станок</translation>
    </message>
    <message>
        <source>&amp;6 Correction</source>
        <translation>&amp;6 Коррекция</translation>
    </message>
    <message>
        <source>not compensated</source>
        <translation>не компенсируется</translation>
    </message>
    <message>
        <source>Save the job in the journal; “Save case as…” writes a file</source>
        <translation>Сохранить работу в журнале; в файл — «Сохранить задачу как…»</translation>
    </message>
    <message>
        <source>Swap the rod ends</source>
        <translation>Поменять головки шатуна</translation>
    </message>
    <message>
        <source>Correct the drilled holes</source>
        <translation>Исправить просверленное</translation>
    </message>
    <message>
        <source>no action required</source>
        <translation>действия не требуются</translation>
    </message>
    <message>
        <source>Save the job in the journal to continue later</source>
        <translation>Сохранить работу в журнале, чтобы продолжить позже</translation>
    </message>
    <message>
        <source>Next job: engine values are kept, other fields are cleared</source>
        <translation>Следующая работа: данные двигателя сохраняются, остальное пусто</translation>
    </message>
    <message>
        <source>Preview the job card</source>
        <translation>Посмотреть карту</translation>
    </message>
    <message>
        <source>Entries not accepted</source>
        <translation>Непринятые значения</translation>
    </message>
    <message>
        <source>The sheet has no number of engine or crankshaft and no customer: the journal could not find the job.</source>
        <translation>На листе нет ни номера двигателя или вала, ни заказчика: журнал не сможет найти работу.</translation>
    </message>
    <message>
        <source>The job in the journal is for %1, the sheet for %2.</source>
        <translation>Работа в журнале — двигателя %1, на листе — %2.</translation>
    </message>
    <message>
        <source>The job of %1 in the journal is finished, verdict: %2. With this sheet the verdict is: %3.</source>
        <translation>Работа %1 в журнале закончена, заключение: %2. С этим листом заключение: %3.</translation>
    </message>
    <message>
        <source>Another engine: planes, heavy metal, nominal masses, service speed and own limit of the previous crankshaft are cleared. Undo restores them.</source>
        <translation>Другой двигатель: плоскости, тяжёлый металл, номинальные массы, рабочая частота вращения и свой предел прежнего вала очищены. Отмена вернёт их.</translation>
    </message>
    <message>
        <source>Restore the backup</source>
        <translation>Восстановить из копии</translation>
    </message>
    <message>
        <source>Understood</source>
        <translation>Понятно</translation>
    </message>
    <message>
        <source>Use the present plan</source>
        <translation>Принять текущий план</translation>
    </message>
</context>
<context>
    <name>ravnoves::WorkshopSheet</name>
    <message>
        <source>Read as %1: %2</source>
        <translation>Прочитано как %1: %2</translation>
    </message>
    <message>
        <source>Read as one value: %1</source>
        <translation>Прочитано как одно значение: %1</translation>
    </message>
</context>
</TS>
