<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru_RU">
<context>
    <name>JobCard</name>
    <message>
        <source>custom</source>
        <translation>свой</translation>
    </message>
    <message>
        <source>Job card: crankpin plugs and bob weights</source>
        <translation>Карта: пробки и балансировочные грузы</translation>
    </message>
    <message>
        <source>V-8 engine %1</source>
        <translation>Двигатель V-8, %1</translation>
    </message>
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
        <source>Work · crankshaft</source>
        <translation>Работа · вал</translation>
    </message>
    <message>
        <source>Excess on each crankpin Δm_y = %1 (%2)</source>
        <translation>Неуравновешенная масса на каждой шатунной шейке Δm_у = %1 (%2)</translation>
    </message>
    <message>
        <source>The data are not complete; nothing can be advised.</source>
        <translation>Данные неполны, совета дать нельзя.</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Двигатель</translation>
    </message>
    <message>
        <source>Heavier than nominal by</source>
        <translation>Тяжелее номинала на</translation>
    </message>
    <message>
        <source>Excess Δm_y</source>
        <translation>Всего Δm_у</translation>
    </message>
    <message>
        <source>Options, in the order of cost</source>
        <translation>Варианты по возрастанию затрат</translation>
    </message>
    <message>
        <source>constant, %1</source>
        <translation>постоянная, %1</translation>
    </message>
    <message>
        <source>reach, %1</source>
        <translation>предел, %1</translation>
    </message>
    <message>
        <source>needed, %1</source>
        <translation>снять, %1</translation>
    </message>
    <message>
        <source>limit, %1</source>
        <translation>можно, %1</translation>
    </message>
    <message>
        <source>left, %1</source>
        <translation>остаток, %1</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>вывод</translation>
    </message>
    <message>
        <source>no such plug</source>
        <translation>нет пробки</translation>
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
        <source>Each compensates constant + k_y × lightening of one plug, k_y = %1 (slope %2°); needed: lightening of one plug.</source>
        <translation>Компенсируется: постоянная + k_у × снятая с одной пробки масса, k_у = %1 (угол %2°); «снять» и «можно» — с одной пробки.</translation>
    </message>
    <message>
        <source>Bob weight on each crankpin, %1</source>
        <translation>Балансировочный груз на шатунную шейку, %1</translation>
    </message>
    <message>
        <source>Not known without: %1.</source>
        <translation>Неизвестен, нужны: %1.</translation>
    </message>
    <message>
        <source>Plug</source>
        <translation>Пробка</translation>
    </message>
    <message>
        <source>factor × mass</source>
        <translation>коэффициент × масса</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>коэфф.</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>номинал</translation>
    </message>
    <message>
        <source>before</source>
        <translation>до</translation>
    </message>
    <message>
        <source>after</source>
        <translation>после</translation>
    </message>
    <message>
        <source>Plug (after: %1)</source>
        <translation>Пробка (после: %1)</translation>
    </message>
    <message>
        <source>Sum: bob weight</source>
        <translation>Сумма: груз</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Цилиндр</translation>
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
        <source>Balancing machine</source>
        <translation>Балансировочный станок</translation>
    </message>
    <message>
        <source>ISO 21940-11, G %1, %2 kg at %3 min⁻¹: U_per = %4 in all.</source>
        <translation>ИСО 21940-11, G %1, %2 кг при %3 мин⁻¹: U_доп = %4 всего.</translation>
    </message>
    <message>
        <source>ISO 21940-11: no grade, mass and speed given.</source>
        <translation>ИСО 21940-11: класс, масса и частота не заданы.</translation>
    </message>
    <message>
        <source>Correction plane</source>
        <translation>Плоскость коррекции</translation>
    </message>
    <message>
        <source>permissible, %1</source>
        <translation>допустимо, %1</translation>
    </message>
    <message>
        <source>reading, %1</source>
        <translation>показание, %1</translation>
    </message>
    <message>
        <source>angle, °</source>
        <translation>угол, °</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>годен</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>не годен</translation>
    </message>
    <message>
        <source>Front (pulley)</source>
        <translation>Передняя (шкив)</translation>
    </message>
    <message>
        <source>Rear (flywheel)</source>
        <translation>Задняя (маховик)</translation>
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
        <source>Ravnoves %1 · method: A. D. Nazarov, equations (3)–(24) · masses in grams, radii in millimetres</source>
        <translation>Ravnoves %1 · метод: А. Д. Назаров, формулы (3)–(24) · массы в граммах, радиусы в миллиметрах</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1: не удалось записать: %2</translation>
    </message>
    <message>
        <source>Weights of the parts by cylinder, %1</source>
        <translation>Массы деталей по цилиндрам, %1</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>среднее</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>разброс</translation>
    </message>
</context>
<context>
    <name>V8</name>
    <message>
        <source>g</source>
        <comment>unit</comment>
        <translation>г</translation>
    </message>
    <message>
        <source>mm</source>
        <comment>unit</comment>
        <translation>мм</translation>
    </message>
    <message>
        <source>g·mm</source>
        <comment>unit</comment>
        <translation>г·мм</translation>
    </message>
    <message>
        <source>thread</source>
        <comment>drawing</comment>
        <translation>резьба</translation>
    </message>
    <message>
        <source>Machine all 8 steel plugs by %1 each.</source>
        <translation>Снять с каждой из 8 стальных пробок %1.</translation>
    </message>
    <message>
        <source>Fit today&apos;s 8 steel plugs as they are.</source>
        <translation>Поставить 8 существующих стальных пробок без доработки.</translation>
    </message>
    <message>
        <source>Replace all 8 plugs by aluminium ones lightened by %1 each.</source>
        <translation>Заменить все 8 пробок алюминиевыми, сняв с каждой %1.</translation>
    </message>
    <message>
        <source>Replace all 8 plugs by aluminium ones as they are.</source>
        <translation>Заменить все 8 пробок алюминиевыми без доработки.</translation>
    </message>
    <message>
        <source>leaves %1 too much on each crankpin</source>
        <translation>оставляет %1 лишних на каждой шейке</translation>
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
        <source>Plug radius r_p</source>
        <translation>Радиус пробки r_р</translation>
    </message>
    <message>
        <source>New plug radius r_pn</source>
        <translation>Радиус новой пробки r_рн</translation>
    </message>
    <message>
        <source>Steel plug m_p</source>
        <translation>Стальная пробка m_р</translation>
    </message>
    <message>
        <source>Aluminium plug m_a</source>
        <translation>Алюминиевая пробка m_а</translation>
    </message>
    <message>
        <source>New steel plug m_pn</source>
        <translation>Новая стальная m_рн</translation>
    </message>
    <message>
        <source>New aluminium plug m_an</source>
        <translation>Новая алюминиевая m_ан</translation>
    </message>
    <message>
        <source>Most off steel plug Δm_pm</source>
        <translation>Предел со стальной Δm_рm</translation>
    </message>
    <message>
        <source>Most off aluminium plug Δm_am</source>
        <translation>Предел с алюминиевой Δm_аm</translation>
    </message>
    <message>
        <source>Rod coefficient k_r</source>
        <translation>Коэффициент шатуна k_ш</translation>
    </message>
    <message>
        <source>Oil in a crankpin m_m</source>
        <translation>Масло в шейке m_м</translation>
    </message>
    <message>
        <source>Oil coefficient k_m</source>
        <translation>Коэффициент масла k_м</translation>
    </message>
    <message>
        <source>Reciprocating mass m_j</source>
        <translation>Поступательная масса m_j</translation>
    </message>
    <message>
        <source>Rotating mass m_R</source>
        <translation>Вращающаяся масса m_R</translation>
    </message>
    <message>
        <source>Improved piston Δm_pi</source>
        <translation>Поршень Δm_п</translation>
    </message>
    <message>
        <source>Rod big end Δm_be</source>
        <translation>Головка шатуна Δm_шк</translation>
    </message>
    <message>
        <source>Repair piston and rings Δm_rp</source>
        <translation>Рем. поршень, кольца Δm_рп</translation>
    </message>
    <message>
        <source>Repair shells Δm_sh</source>
        <translation>Рем. вкладыши Δm_шр</translation>
    </message>
    <message>
        <source>Residual unbalance allowed</source>
        <translation>Допустимый дисбаланс</translation>
    </message>
    <message>
        <source>Machine today&apos;s steel plugs</source>
        <translation>Облегчить стальные пробки</translation>
    </message>
    <message>
        <source>Aluminium plugs</source>
        <translation>Алюминиевые пробки</translation>
    </message>
    <message>
        <source>New crankshaft, today&apos;s steel plugs</source>
        <translation>Новый вал, прежние стальные пробки</translation>
    </message>
    <message>
        <source>New crankshaft, aluminium plugs</source>
        <translation>Новый вал, алюминиевые пробки</translation>
    </message>
    <message>
        <source>Plug</source>
        <translation>Пробка</translation>
    </message>
    <message>
        <source>Oil m_m</source>
        <translation>Масло m_м</translation>
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
        <translation>Под новые пробки</translation>
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
        <source>Leave the plugs as they are: the excess of %1 per crankpin is %2.</source>
        <translation>Пробки оставить без изменений: лишние %1 на шейку дают %2.</translation>
    </message>
    <message>
        <source>This %1: %2.</source>
        <comment>leaves …: … g·mm, within …</comment>
        <translation>Это %1: %2.</translation>
    </message>
    <message>
        <source>The crankshaft is made for plugs of the new design; their mass and radius are needed.</source>
        <translation>Вал изготовлен под новые пробки: нужны их масса и радиус.</translation>
    </message>
    <message>
        <source>The parts are %1 per crankpin lighter than nominal (%2), and plugs can only be lightened: heavier parts or heavier plugs are needed.</source>
        <translation>Детали легче номинала на %1 на шейку (%2), а пробки можно только облегчить: нужны более тяжёлые детали или пробки.</translation>
    </message>
    <message>
        <source>No plug of this crankshaft can be made light enough.</source>
        <translation>Ни одну пробку этого вала нельзя облегчить настолько.</translation>
    </message>
    <message>
        <source>No plug of this crankshaft has the mass that is needed.</source>
        <translation>Ни одна пробка этого вала не даёт нужной массы.</translation>
    </message>
    <message>
        <source>The nearest is “%1”, which %2: %3.</source>
        <comment>option, leaves …, … g·mm against …</comment>
        <translation>Ближе всего «%1»: %2, то есть %3.</translation>
    </message>
    <message>
        <source>A crankshaft made for the new plugs would do: “%1”.</source>
        <translation>Подошёл бы вал под новые пробки: «%1».</translation>
    </message>
    <message>
        <source>A standard crankshaft would do: “%1”.</source>
        <translation>Подошёл бы штатный вал: «%1».</translation>
    </message>
    <message>
        <source>It cannot be bored with a %1 cutter: a wall of %2 would be left under the thread, and %3 must stay.</source>
        <translation>Фрезой %1 расточить нельзя: под резьбой осталась бы стенка %2, а должно быть %3.</translation>
    </message>
    <message>
        <source>It cannot be bored with a %1 cutter: a bore %2 deep is needed, and a bottom of %3 must stay.</source>
        <translation>Фрезой %1 расточить нельзя: нужна глубина %2, а дно должно остаться %3.</translation>
    </message>
    <message>
        <source>Bore %1 deeper with a %2 cutter, to %3 from the face.</source>
        <translation>Углубить на %1 фрезой %2, до %3 от торца.</translation>
    </message>
    <message>
        <source>Bore with a %1 cutter to %2 from the face.</source>
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
        <source>%1 plug: a plug of these dimensions weighs %2, but %3 was typed. Weigh it.</source>
        <translation>%1: пробка таких размеров весит %2, а введено %3. Взвесьте её.</translation>
    </message>
    <message>
        <source>Neglected by the method: the plug&apos;s centre of mass moves by 0.8 to 1.2 mm when it is bored, which is worth %1 to %2 beside the %3 allowed.</source>
        <translation>Метод пренебрегает смещением центра масс пробки на 0,8–1,2 мм при расточке: это %1–%2 при допустимых %3.</translation>
    </message>
    <message>
        <source>After equals nominal: balanced.</source>
        <translation>После равно номиналу: уравновешено.</translation>
    </message>
    <message>
        <source>After less nominal: %1, which is %2.</source>
        <translation>После минус номинал: %1, то есть %2.</translation>
    </message>
    <message>
        <source>The parts are placed as well as can be: the crankpins differ by %1.</source>
        <translation>Детали размещены наилучшим образом: разница между шейками %1.</translation>
    </message>
    <message>
        <source>Crankpins differ by %1 as weighed and by %2 after moving %3 sets.</source>
        <translation>Разница между шейками %1, после перестановки комплектов (%3) — %2.</translation>
    </message>
    <message>
        <source>l</source>
        <comment>litre</comment>
        <translation>л</translation>
    </message>
    <message>
        <source>reciprocating m_j</source>
        <translation>поступат. m_j</translation>
    </message>
    <message>
        <source>piston Δm_pi</source>
        <translation>поршень Δm_п</translation>
    </message>
    <message>
        <source>rep. piston Δm_rp</source>
        <translation>поршень Δm_рп</translation>
    </message>
    <message>
        <source>rotating m_R</source>
        <translation>вращ. m_R</translation>
    </message>
    <message>
        <source>plug</source>
        <translation>пробка</translation>
    </message>
    <message>
        <source>big end Δm_be</source>
        <translation>шатун Δm_шк</translation>
    </message>
    <message>
        <source>rep. shells Δm_sh</source>
        <translation>вкладыши Δm_шр</translation>
    </message>
    <message>
        <source>oil m_m</source>
        <translation>масло m_м</translation>
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
        <source>new shaft, steel</source>
        <translation>новый вал, сталь</translation>
    </message>
    <message>
        <source>new shaft, aluminium</source>
        <translation>новый вал, алюм.</translation>
    </message>
    <message>
        <source>Hang %1 on each crankpin.</source>
        <translation>Груз на каждую шейку: %1.</translation>
    </message>
    <message>
        <source>Bob weight with the nearest option: %1.</source>
        <translation>Груз при ближайшем варианте: %1.</translation>
    </message>
    <message>
        <source>kg</source>
        <comment>unit</comment>
        <translation>кг</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <comment>unit</comment>
        <translation>кг/м³</translation>
    </message>
    <message>
        <source>mm/s</source>
        <comment>unit</comment>
        <translation>мм/с</translation>
    </message>
    <message>
        <source>min⁻¹</source>
        <comment>unit</comment>
        <translation>мин⁻¹</translation>
    </message>
    <message>
        <source>%1 plug: solid it weighs %2, but %3 was typed. Give its bore or weigh it.</source>
        <translation>%1: сплошная пробка весит %2, а введено %3. Укажите расточку или взвесьте.</translation>
    </message>
    <message>
        <source>%1: %2 of 8 weighed; nominal counts until all are.</source>
        <translation>%1: взвешено %2 из 8; пока не все, считается номинал.</translation>
    </message>
    <message>
        <source>%1: the weights do not count without a nominal mass.</source>
        <translation>%1: без номинальной массы взвешивание не учитывается.</translation>
    </message>
    <message>
        <source>%1: must be less than the plug&apos;s mass, %2.</source>
        <translation>%1: должно быть меньше массы пробки, %2.</translation>
    </message>
    <message>
        <source>The bore is as deep as the plug is high: there is no bottom.</source>
        <translation>Полость глубиной с пробку: дна нет.</translation>
    </message>
    <message>
        <source>The bore is wider than the root of the thread, %1: there is no wall.</source>
        <translation>Полость шире впадины резьбы, %1: стенки нет.</translation>
    </message>
    <message>
        <source>A bore needs both its diameter and its depth.</source>
        <translation>У полости нужны и диаметр, и глубина.</translation>
    </message>
    <message>
        <source>%1: spread %2, permitted %3 (heaviest: cylinder %4, lightest: %5).</source>
        <translation>%1: разброс %2, допустимо %3 (тяжелее всех: цилиндр %4, легче всех: %5).</translation>
    </message>
    <message>
        <source>Bored as planned here it moves by %1: %2.</source>
        <translation>При этой расточке он смещается на %1: %2.</translation>
    </message>
</context>
<context>
    <name>ravnoves::AnswerView</name>
    <message>
        <source>The four options</source>
        <translation>Четыре варианта</translation>
    </message>
    <message>
        <source>Bob weight on each crankpin</source>
        <translation>Балансировочный груз на шейку</translation>
    </message>
    <message>
        <source>Bob weight on each crankpin, line by line</source>
        <translation>Балансировочный груз на шейку по строкам</translation>
    </message>
</context>
<context>
    <name>ravnoves::BalanceShaftPage</name>
    <message>
        <source>&amp;Piston</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass of the piston. TMZ-650D: 0.645 kg (0.640). Source: Gots and Klevtsov, Table 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Piston p&amp;in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass of the piston pin. TMZ-650D: 0.241 kg. Source: Table 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rin&amp;gs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass of the piston rings. TMZ-650D: 0.1 kg. Source: Table 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rod, small-&amp;end share</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of the rod&apos;s mass that moves with the piston. TMZ-650D: 0.33 kg of 0.950 kg. Source: Table 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the crank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the α of the least &amp;range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the α of the least R&amp;MS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine</source>
        <translation type="unfinished">Двигатель</translation>
    </message>
    <message>
        <source>Own values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TMZ-650D: the single-cylinder diesel of Gots and Klevtsov, Tables 1 and 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset TMZ-650D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Speed n</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crankshaft speed. TMZ-650D: 3600 min⁻¹ (the paper prints ω = 376.8 rad/s, with π ≈ 3.14).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ω</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angular speed, n π / 30</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Crank radius r</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half the stroke. TMZ-650D: 46 mm (stroke 92 mm).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rod lengt&amp;h L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between the centres of the rod&apos;s eyes; only the picture uses it. Empty: r / 0.3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>auto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rod length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reciprocating masses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole rod with she&amp;lls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its small-end share above is a part of it; the rest turns with the crankpin and is balanced by the crank&apos;s own counterweights. TMZ-650D: 0.950 ± 0.015 kg. Source: Table 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rod mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sum mⱼ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reciprocating mass: the sum of the parts. TMZ-650D: 1.316 kg.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counterweights and shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coun&amp;terweight radius ρ₁</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the axis to the centre of mass of each of the two equal counterweights. TMZ-650D: 46 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counterweight radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counterweight &amp;mass m₁</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Empty: by equation (1), m₁ = mⱼ r / (2 ρ₁). A number overrides it. TMZ-650D: 0.658 kg.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by (1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counterweight mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre &amp;distance l</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the crank axis to the shaft axis. The paper does not print it; 100.15 mm follows from the printed amplitude 430.39 N·m.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sizes for picture and envelope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cylinder &amp;bore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Empty: the stroke, 2 r.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank swing radi&amp;us</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circle swept by crank and counterweight. Empty: 1.3 times the larger of r and ρ₁.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaft swin&amp;g radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circle swept by the balance shaft. Empty: 1.3 ρ₁.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gear tip r&amp;adius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tip circle of each of the two gears. Empty: l/2, the pitch circle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Housing &amp;wall and gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added around every circle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>straight lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>periodic cubic spline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque between the rows of its table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I&amp;nterpolation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The paper&apos;s table has a row every 15°; criteria are those of the curve between the rows, not of the rows alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaft angle &amp;α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle from the cylinder axis to the line of centres, in the direction of rotation; 90° is beside the crank. 0 to 360°, steps of 0.1°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mea&amp;ns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cycle integral</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paper&apos;s nodes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which means the plots show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean of Mₛ over a cycle is 0 at every α. The paper averages 25 nodes and counts the end of the cycle twice; that alone makes its mean differ from 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>φ, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moments over the cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tipping moment, −M_id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moment of the balance shaft, P₁ l sin(α + φ), (4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moment on the mounts, Mᵤₚ + Mₛ, (5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range and RMS over α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean Mₛ, N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range of Mᵤₚₛ, max − min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS of Mᵤₚₛ about its mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mₛ mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cycle mean of Mₛ: 0 at every α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mₛ mean (paper)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean of 25 nodes, the end counted twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Means over α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mₛₘ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cycle mean of Mₛ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mᵤₚₛₘ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cycle mean of Mᵤₚₛ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mₛₘ (paper)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mᵤₚₛₘ (paper)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Node mean of Mᵤₚ plus that of Mₛ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;φ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank angle of the picture; 0 is top dead centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Criteria of the three moments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the α of the least range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the α of the least RMS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces, masses and sizes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> kg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 kg of it are not listed above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> rad/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relief</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::BalanceShaftViewModel</name>
    <message>
        <source>Every α is as good as any other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open case</source>
        <translation type="unfinished">Открытие задачи</translation>
    </message>
    <message>
        <source>New case</source>
        <translation type="unfinished">Новая задача</translation>
    </message>
    <message>
        <source>Torque source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pressure trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mᵤₚ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mₛ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mᵤₚₛ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nodes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished">мм</translation>
    </message>
    <message>
        <source>Inertia force Pⱼ₁, max</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counterweight m₁</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kg</source>
        <translation type="unfinished">кг</translation>
    </message>
    <message>
        <source>Counterweight force P₁</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amplitude of Mₛ, P₁ l</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First order&apos;s share of Mᵤₚ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Envelope, width × height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Indicated mean effective pressure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Indicated work per cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>J</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Indicated power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kW</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean torque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peak pressure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at crank angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cm³</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clearance volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heat per cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least range %2 N·m at %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least RMS %2 N·m at %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shaft makes no moment, so its angle changes nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No α makes the range smaller than without a shaft: at best %1 N·m against %2 N·m.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No α makes the RMS smaller than without a shaft: at best %1 N·m against %2 N·m.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The counterweight given balances %1 % of the first-order inertia force; equation (1) asks for %2 kg.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The torque holds an inertia torque of mⱼ r² ω² = %1 N·m; the masses and the speed entered give %2 N·m. It fits these masses at %3 min⁻¹, or %4 kg at this speed.</source>
        <translation type="unfinished"></translation>
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
        <translation>Компенсируемая масса от облегчения одной пробки</translation>
    </message>
    <message>
        <source>Δm_y, g</source>
        <translation>Δm_у, г</translation>
    </message>
    <message>
        <source>today %1</source>
        <translation>сейчас %1</translation>
    </message>
    <message>
        <source>lightening of one plug Δm, g</source>
        <translation>облегчение одной пробки Δm, г</translation>
    </message>
</context>
<context>
    <name>ravnoves::CounterweightView</name>
    <message>
        <source>Rotating masses and counterweights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crank from the front with crankpin 1 up; angles from crankpin 1, counter-clockwise, lags against the rotation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force Σ e^{iκ} = %1 at %2; opposite: %3 against the rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moment Σ z e^{iκ} = %1 mm at %2; opposite: %3 against the rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 g at ρ %3 mm, %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>front web</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rear web</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(switched off)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No counterweights: switch them on under Balancing.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::CycleView</name>
    <message>
        <source>The torque is a table.
Choose “pressure trace” or “computed cycle” on the Torque tab to see gas and inertia torque, pressure and indicator diagram.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine torque and its parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>φ, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>−(p − p₀) A s′</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inertia</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>−mⱼ ω² s′ s″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M_id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine torque, gas plus inertia</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cylinder pressure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Indicator diagram, p–V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Work, pressures and power of the cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V, cm³</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V without clearance, cm³</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::CylinderEditor</name>
    <message>
        <source>Add a cylinder below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected cylinders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy (Ctrl+C)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;ven firing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets the crankpins so that the cylinders fire at even intervals over 720° in the firing order: against the in-line engine they are shifted by γ + 2 φ_TDC (the paper prints γ + φ_TDC; its own angle, 21°40′, is the one with 2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cylinders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cylinders of the layout chosen. Editing one makes this a table of your own; Ctrl+V pastes from a spreadsheet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your own table. Double-click a cell to edit; Ctrl+V pastes from a spreadsheet.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::CylinderTableModel</name>
    <message>
        <source>Cylinder %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cylinder %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>z, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>β, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>e, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>κ, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axial position, positive towards cylinder 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction of the cylinder&apos;s axis, counter-clockwise from up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of the cylinder&apos;s axis from the crank axis, positive on the counter-clockwise side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crankpin, counter-clockwise from crankpin 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An engine has at least one cylinder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most %1 cylinders.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1, column %2: %3 is no number that fits here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clipboard holds no numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste cylinders</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::ElasticHingePage</name>
    <message>
        <source>&amp;Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play the computed motion in slow motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;ω</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank speed that the hinges are designed for. Paper: 100, 300 and 500 rad/s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;λ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ratio λ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank radius to rod length. Paper: 0.3. Below 1; λ = 1 can be drawn with the series only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;c</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kN/m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness of the spring of the crank&apos;s hinge. Paper: 20 000 kN/m. A softer spring gives more relief.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;ρ₀</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished">мм</translation>
    </message>
    <message>
        <source>Guide radius ρ₀</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the guide at φ = 0. Below ℓ₀/2 the spring is compressed, above it is stretched. Paper: 90 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ℓ&amp;₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counterweight&apos;s distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the crankpin to the counterweight on the rod. Paper: 50, 100 and 150 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amplitude of the waves on the guide&apos;s profile as it is made. Good grinding leaves a few micrometres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause the motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both hinges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which motion is played</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which of the computed motions the picture plays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;φ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank angle of the picture, counter-clockwise from the slider line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take this pre&amp;load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take this sti&amp;ffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the design gives</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::ElasticHingeViewModel</name>
    <message>
        <source>Zotov and Sviridov 2021</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open case</source>
        <translation type="unfinished">Открытие задачи</translation>
    </message>
    <message>
        <source>New case</source>
        <translation type="unfinished">Новая задача</translation>
    </message>
    <message>
        <source>No spring is given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None: at λ = 1 the mechanism locks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None: the hinge has no energy to give out, its guide is a circle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None: a spring of %1 mm that gets no shorter than %2 mm leaves no room for this relief.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None: with a spring of %1 mm this relief needs an outer diameter of at least %2 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None: the roller of radius %1 mm undercuts every guide with this relief.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None: the stiffness that would be needed is out of range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>c = %1 kN/m, ρ₀ = %2 mm: relief %3 mm within %4 mm; the spring is at least %5 mm long, bears up to %6 kN and stores up to %7 J.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take over the guide found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preload that the guide needs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness that the guide needs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At λ = 1 the mechanism locks: there is no guide and no motion. The series still draws M₁₂ and the side force.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No spring is given, so there is no guide.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No guide: the spring would have to be compressed by %1 mm of its %2 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No guide: from φ = %1° on the spring would have to give out more than it stores (most at %2°). It needs a preload |ℓ₀/2 − ρ₀| of %3 mm and has %4 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, or with this preload a stiffness of %1 kN/m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The roller of radius %1 mm undercuts the guide: at most %2 mm follow it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The guide exists, but with the printed sign it stores what the mechanism takes up: the crank does not keep its speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The guide exists, but cannot be made: with a relief of %1 mm a profile error of %2 µm changes its moment by up to %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The guide exists: relief %1 mm; a profile error of %2 µm changes its moment by up to %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished">мм</translation>
    </message>
    <message>
        <source>Relief of the guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preload needed / given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spring travel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest spring force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moment error from %1 µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least curvature radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest roller radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>∮ M₁₂ dφ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>J</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side force without hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side force with rod hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counterweight P₄</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kg</source>
        <translation type="unfinished">кг</translation>
    </message>
    <message>
        <source>reverses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ripple without hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ripple with hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ripple from %1 rad/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series is off by %1 in cos ψ at φ = %2°; use the exact kinematics for a design.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Equation (9) as printed has the wrong sign at the counterweight&apos;s inertia: the slider would still bear up to %1 N. Newton–Euler makes the side force zero.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2…%3 rad/s, drift %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the crank stops after %2 turns and would turn back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: only %2 turns in %3 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both hinges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from %1 rad/s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::EngineSheet</name>
    <message>
        <source>There are &amp;aluminium plugs</source>
        <translation>Есть &amp;алюминиевые пробки</translation>
    </message>
    <message>
        <source>There are plugs of the new &amp;design</source>
        <translation>Есть пробки &amp;новой конструкции</translation>
    </message>
    <message>
        <source>&amp;Keep as own engine…</source>
        <translation>&amp;Запомнить двигатель…</translation>
    </message>
    <message>
        <source>Rena&amp;me…</source>
        <translation>&amp;Переименовать…</translation>
    </message>
    <message>
        <source>Remo&amp;ve…</source>
        <translation>&amp;Удалить…</translation>
    </message>
    <message>
        <source>Crankshaft and today&apos;s plugs</source>
        <translation>Вал и существующие пробки</translation>
    </message>
    <message>
        <source>Nominal masses, for the bob weight</source>
        <translation>Номинальные массы, для груза</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>нужно</translation>
    </message>
    <message>
        <source>Name of the engine:</source>
        <translation>Название двигателя:</translation>
    </message>
    <message>
        <source>The engine needs a name.</source>
        <translation>Двигателю нужно название.</translation>
    </message>
    <message>
        <source>Keep as own engine</source>
        <translation>Запомнить двигатель</translation>
    </message>
    <message>
        <source>An engine “%1” is kept already. Replace its values?</source>
        <translation>Двигатель «%1» уже сохранён. Заменить его данные?</translation>
    </message>
    <message>
        <source>Engine %1 kept.</source>
        <translation>Двигатель %1 запомнен.</translation>
    </message>
    <message>
        <source>Rename own engine</source>
        <translation>Переименование двигателя</translation>
    </message>
    <message>
        <source>The engine is called %1 now.</source>
        <translation>Двигатель теперь называется %1.</translation>
    </message>
    <message>
        <source>Remove engine</source>
        <translation>Удаление двигателя</translation>
    </message>
    <message>
        <source>Remove “%1” from your own engines?</source>
        <translation>Удалить «%1» из своих двигателей?</translation>
    </message>
    <message>
        <source>Engine %1 removed.</source>
        <translation>Двигатель %1 удалён.</translation>
    </message>
</context>
<context>
    <name>ravnoves::EngineView</name>
    <message>
        <source>Engine from the front and the crank from the side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To scale; the crank turns counter-clockwise. Drag to turn it, Space plays and pauses, the arrow keys step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>φ = %1°</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::EnvelopeView</name>
    <message>
        <source>Overall size over α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished">мм</translation>
    </message>
    <message>
        <source>width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range against overall size, α along the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ΔMᵤₚₛ, N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing better</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No other α has both a smaller box and a smaller range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>present α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The box around cylinder, crank circle, shaft circle and gears, with the wall, in the front view. It is not checked that the shaft clears cylinder and rod. Radii, bore and wall are on the Inputs tab. Click either chart to set α.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>width × height, cm²</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::FiringWheel</name>
    <message>
        <source>Firing order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One four-stroke cycle of 720°, counter-clockwise from the top: cylinders in the order of firing, the intervals between them, the present crank angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No firing order given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The order %1 cannot be run through in two turns of this crank.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>even, every %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>uneven, %1° to %2°</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::ForcesView</name>
    <message>
        <source>Share &amp;κ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of mⱼ r balanced on the crank alone, without a shaft. The force then runs on an ellipse: a line at 0 and 1, a circle at ½.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share κ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force on the engine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>across, kN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along the cylinder, kN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank only, 1st + 2nd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First and second order without a shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank only, 1st</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First order without a shaft: an ellipse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the shaft the first order is a point; the second order along the cylinder stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces with and without a shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teeth z of each gear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teeth of each of the two equal gears.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teeth k by which the shaft is out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shaft is assembled k teeth ahead of its right place: a phase error of 360° k / z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backlash, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circumferential play at the pitch circle, whose radius is l/2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;k</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>play, &amp;mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shifted teeth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backlash</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mᵤₚₛ with gear error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>φ, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>play, low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Band that the play of the gears leaves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaft in its right place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k teeth out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaft k teeth out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effect of gear error and play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gears</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1st order, P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along, (1 − κ) P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>across, κ P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1st with shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2nd order, λ P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on crank, κ mⱼ r</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>g·mm</source>
        <translation type="unfinished">г·мм</translation>
    </message>
    <message>
        <source>First-order inertia force, mⱼ r ω²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half-axis of the ellipse along the cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half-axis of the ellipse across the cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First order that the shaft&apos;s two counterweights leave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second order along the cylinder; stays with and without a shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Static moment of the counterweight on the crank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phase error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>play, ±</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>range in play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>360° k / z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Constant force that turns against the crank, 2 P₁ |sin(δ/2)|</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ΔMᵤₚₛ, shaft in its right place → k teeth out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS of Mᵤₚₛ, shaft in its right place → k teeth out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shaft wanders this far to either side: play / l</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least and largest ΔMᵤₚₛ while the shaft wanders</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::GuideExportForm</name>
    <message>
        <source>Guide for the machine shop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank, for M</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank, for M₁</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rod, for M₁₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which hinge&apos;s guide is written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>compressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stretched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;pring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The side of its free length on which the spring works</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guide turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spring turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;What turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the paper the guide turns with the crank and the spring stands still: the roller then runs backwards in the guide&apos;s own axes, and the drawing is the mirror image of the plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chord to&amp;lerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DXF: the polyline leaves the curve by no more than that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;tep of the table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV: step of the crank angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write D&amp;XF…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closed polylines in mm, 1:1: layers PROFILE, ROLLER_PATH, AXIS, NOTE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write &amp;CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank angle, polar angle, radius, x and y of path and profile; °, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DXF drawing (*.dxf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation type="unfinished">Таблица CSV (*.csv)</translation>
    </message>
    <message>
        <source>This guide does not exist; see the answer on the right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The roller undercuts this guide.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The profile is offset from the path of the roller&apos;s centre by the roller&apos;s radius.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 written</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::GuideSearchForm</name>
    <message>
        <source>Finds stiffness and preload that give the crank&apos;s guide a relief that can be made, with the free length, the roller and the side of the spring as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wanted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;elief</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference between the guide&apos;s largest and least radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Outer diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guide and rollers must fit in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Shortest spring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The spring gets no shorter than that (its solid length). Empty: 0.4 ℓ₀.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0.4 ℓ₀</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Take it over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets c and ρ₀ to the values found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wanted relief</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outer diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortest spring</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no help on this page yet.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::HingeInputs</name>
    <message>
        <source>Mechanism</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zotov and Sviridov</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mechanism of the paper, with ρ₀ = 90 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weights, N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>masses, kg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Given &amp;as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The paper gives weights. With masses gravity may be 0: a mechanism that lies flat.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights or masses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Crank radius r</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the crank&apos;s axis to the crankpin; the rod is r/λ long. Paper: 50 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paper&apos;s series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Kinematics of M₁₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The paper&apos;s series for cos ψ is good for small λ only; the exact one needs λ &lt; 1. M and the crank&apos;s guide are always exact.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kinematics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;rank P₁</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;rank m₁</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crank is a uniform bar of length r. Paper: 5 N.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ro&amp;d P₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ro&amp;d m₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rod is a uniform bar of length r/λ. Paper: 6.5 N.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;lider P₃</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;lider m₃</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paper: 6 N.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Gravity g</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The paper takes 9.82 m/s²; the standard value is 9.80665 m/s².</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Springs and guides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Free length ℓ₀</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the unloaded spring of the crank&apos;s hinge. Paper: 200 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keeps the energy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as printed (1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign of the g&amp;uide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A spring that keeps the crank&apos;s speed gives out what the mechanism takes up: Π = const − (T + V). Equation (1) as printed has a plus.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign of the guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own spring for the rod&apos;s &amp;hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Else the rod&apos;s hinge has the same spring as the crank&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spring of the rod&apos;s hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its &amp;stiffness c</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the rod hinge&apos;s own spring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its free length &amp;ℓ₀</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its radius ρ&amp;₀</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the rod hinge&apos;s own guide at θ = 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counterweight on the rod</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counter&amp;weight beyond the crankpin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the distance ℓ₂ beyond the crankpin (slider above). With the weight of (10) the rod&apos;s hinge makes the side force zero.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counterweight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight P&amp;₄</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass m&amp;₄</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Empty: solved from (10), P₄ ℓ₂ = (P₃ + P₂/2) ℓ, so that M₁₂ has no mean.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by (10)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counterweight P₄</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as printed (9)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newton–Euler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Inertia in M₁₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Equation (9) as printed has the wrong sign at the counterweight&apos;s inertia forces; with moments about A the side force vanishes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counterweight&apos;s inertia</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roller radi&amp;us</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ρ is the path of the roller&apos;s centre; the profile is offset from it by the roller&apos;s radius. The paper takes 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roller radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error &amp;waves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The profile&apos;s error is taken as so many waves in one turn: 1 is a guide out of centre, 2 an oval one. A whole number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error waves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tur&amp;ns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns of the crank to compute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off-design sp&amp;eed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A start away from the design speed ω, for comparison: the hinge is exact at one speed only. Empty: 1.2 ω.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1.2 ω</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off-design speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;tart angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank angle at which the motion starts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Moment on the crank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A constant moment that drives the crank; negative brakes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moment on the crank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the profile &amp;error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crank&apos;s guide as it was made, with the waves of the profile error: the crank&apos;s speed then follows them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile error in the motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Families of curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank speeds that the plots compare, rad/s. Paper: 100, 300, 500.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speeds ω, rad/s&amp;;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>λ that the side force is compared for. Paper: 0.3, 0.4, 0.6, 0.8, 1 (1 with the series only).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ratios &amp;λ</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::HingeMechanismView</name>
    <message>
        <source>Picture of the mechanism with its hinges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mechanism to scale, the guide&apos;s relief enlarged as in the plot. The guide turns with the crank, the spring stands still. Space plays the computed motion in slow motion, dragging turns the crank.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>φ = %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ω = %1 rad/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relief × %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 times slower</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::HingePlots</name>
    <message>
        <source>What the roller touches: the path of its centre offset by its radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Guides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;od hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sid&amp;e force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank &amp;moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mo&amp;tion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>φ, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank, for M</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank, for M₁</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rod, for M₁₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which guide is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hinge between frame and crank alone (M), the same beside the rod&apos;s hinge (M₁), or the hinge between crank and rod, whose guide goes by θ = φ + ψ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Relief ×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pictures enlarge the guide&apos;s relief by this factor; 1 is to scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a&amp;uto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the factor by the relief</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ρ₀</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ℓ₀ − ρ₀</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>compressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guide of the compressed spring, minus in (3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stretched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guide of the stretched spring, plus in (3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ρ over the turn, from its value at 0°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M₁₂ and its potential part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M₁₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moment on the rod that makes the side force zero, (4), with a counterweight (9)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>potential part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M₁₂ less its mean, (5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M₁₂ by the other kinematics, for comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M₁₂ at several ω</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side force with rod hinge, several λ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side force without hinge, several ω</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 × with hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ten times the side force with the rod&apos;s hinge: the same at every ω</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moment that keeps the crank&apos;s speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without the rod&apos;s hinge, d(T + V)/dφ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M₁</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the rod&apos;s hinge, M + M₁₂ (1 + ψ′), (8); with a counterweight M₁*, (11)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M₁ at several ω</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bare mechanism, from the design speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crank hinge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the crank&apos;s hinge, from the design speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both hinges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the rod&apos;s hinge and the crank&apos;s beside it, from the design speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the crank&apos;s hinge, from another speed: the hinge is exact at one speed only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of the motion computed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop computing the motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guides, to scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guides, relief × %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ρ − ρ(0), µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ρ − ρ(0), mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rad/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M₁*</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M₁* at several ω</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::InertiaMomentsPage</name>
    <message>
        <source>&amp;Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the crank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Shafts on or off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch all balance shafts on, or off when all are on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All shafts off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All shafts on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine</source>
        <translation type="unfinished">Двигатель</translation>
    </message>
    <message>
        <source>Cylinders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balancing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cylinder la&amp;yout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A layout of the library, the paper&apos;s engine, or your own table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Firing order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers of the cylinders, for example 1-2-4-5-3. Layouts with crankpins for even firing follow it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Spacing a</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between neighbouring crankpins (in V engines: throws) along the crank. Volkswagen VR5: 63 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sta&amp;gger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From bank 1&apos;s cylinder to bank 2&apos;s at the same throw, along the crank. 0 where the rods are forked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stagger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Position of cylinder 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axial position z of cylinder 1. Volkswagen VR5: 3 a + l_cm = 204.8 mm, with the centre of mass at z = 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of cylinder 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank gear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Crank radius R</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half the stroke (a little less with offset). Volkswagen VR5: 45 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;λ = R / L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank radius over rod length. Volkswagen VR5: 0.265. The crank turns where λ (1 + |e|/R) &lt; 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>λ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rod length L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R / λ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>φ at TDC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top dead centre: arcsin(λK/(1 + λ)), from the cylinder&apos;s axis on the side of its offset. Volkswagen VR5: 3°20′.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;ciprocating mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of one cylinder: piston with pin and rings, and the rod&apos;s share unless the rod is a rigid body below. Volkswagen VR5: 0.622 kg.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reciprocating mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;otating mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of one throw, reduced to the crank radius: unbalanced part of the throw and the rod&apos;s share unless the rod is a rigid body.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotating mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rod as a rigid body</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off: the rod&apos;s two shares are in the masses above. On: mass, centre and inertia are given; its shares are added, and what its inertia differs from two masses acts on roll moment and torque.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rigid rod</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rod</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rod &amp;mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole rod</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre from &amp;big end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of mass, from the big end towards the small end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Inertia</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About its centre of mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balance shafts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exact orders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two-term form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Designed for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The paper designs its shafts for the two-term form; what they leave of the exact order is then what the two-term form leaves out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Design of the shafts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k order, L distance of the weights (mm), ρ their radius (mm), δ error of phase (°)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Counterweights on the end webs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two weights that cancel force and moment of the rotating masses, and a share of the forward part of the first order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counterweights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Front web at z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axial position of the front weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front &amp;radius ρ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the front weight&apos;s centre of mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;ear web at z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axial position of the rear weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rear ra&amp;dius ρ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the rear weight&apos;s centre of mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Share of order 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the forward part of the reciprocating first order; 1 in a cross-plane V8 cancels it wholly, in a single it is the balance for half the reciprocating mass.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bank an&amp;gle γ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between the banks, 0 to 180°. Crankpins for even firing follow it; those of a table stay, and its bank angles are scaled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>O&amp;ffset e</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished">мм</translation>
    </message>
    <message>
        <source>Distance of the cylinder axes from the crank axis, as far as the mechanism does not lock. Of a table: the largest; the others are scaled with it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed &amp;n</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>min⁻¹</source>
        <translation type="unfinished">мин⁻¹</translation>
    </message>
    <message>
        <source>Crankshaft speed; forces and moments grow with its square.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of mass &amp;z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axial position of the point that moments refer to, in the coordinates of the cylinders; positive towards cylinder 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>φ, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M, N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My 2-term</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical plane, the paper&apos;s formulas (1) and (2), Fig. 6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mx 2-term</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal plane, the paper&apos;s formulas (3) and (4), Fig. 6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the vertical plane, exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mx</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the horizontal plane, exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical plane, with rotating masses and with the counterweights and shafts that are on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mx left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal plane, likewise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fx, N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mx, N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fy, N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My, N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1st</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exact first order (Fig. 5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2nd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exact second order (Fig. 5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All orders of the reciprocating parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All orders with rotating masses, and with the counterweights and shafts that are on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hodographs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;logarithmic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Six decades, so that the high orders can be seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll moment on the engine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll moment on the engine: the sum of the two</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of offsets and rods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moment of the inertia forces about the crank axis: −Σ e F and the couples of rigid rods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reaction torque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reaction of the inertia torque on the crank, −Σ F ds/dφ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shafts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;φ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank angle of the picture, from cylinder 1&apos;s axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amplitudes and phases by order and plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>±kω</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward and backward rotating parts by order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotating masses and counterweights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is left over, by order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::InertiaMomentsViewModel</name>
    <message>
        <source>Single</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In-line 2, 180°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In-line 2, 360°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In-line 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In-line 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In-line 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In-line 6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V-twin 45°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V-twin 60°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V-twin 90°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V6 60°, split pins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V6 90°, split pins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V8, cross-plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V8, flat-plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat twin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat 6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>VR5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>VR6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W12</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open case</source>
        <translation type="unfinished">Открытие задачи</translation>
    </message>
    <message>
        <source>New case</source>
        <translation type="unfinished">Новая задача</translation>
    </message>
    <message>
        <source>Cylinder %1 cannot be joined: its rod reaches the piston at no crank angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mechanism of cylinder %1 locks with its crank at %2° turning forward and at %3° turning back, from the cylinder&apos;s axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>VR%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Even firing needs a firing order.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Even firing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The firing order must name each cylinder from 1 to %1 once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firing order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bank angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaft on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaft off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N; N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phase, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two-term</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>diff., %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+kω</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>−kω</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cancels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mρ, g·mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotating masses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle, °</source>
        <translation type="unfinished">угол, °</translation>
    </message>
    <message>
        <source>lag, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moment, N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>against the force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>against the moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, g·mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, g</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front web</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rear web</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before</source>
        <translation type="unfinished">до</translation>
    </message>
    <message>
        <source>left, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A mechanism is so near locking that the exact orders are less accurate than usual.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1 left out (%2 % of the largest)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 % off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two-term is not enough: order %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>VW VR5 (paper)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::JobSheet</name>
    <message>
        <source>Job</source>
        <translation>Работа</translation>
    </message>
    <message>
        <source>Engine &amp;number</source>
        <translation>&amp;Номер двигателя</translation>
    </message>
    <message>
        <source>The journal finds the job by it.</source>
        <translation>По нему журнал находит работу.</translation>
    </message>
    <message>
        <source>Crankshaft num&amp;ber</source>
        <translation>Номер &amp;вала</translation>
    </message>
    <message>
        <source>As stamped on the crankshaft.</source>
        <translation>Как выбито на валу.</translation>
    </message>
    <message>
        <source>C&amp;ustomer</source>
        <translation>&amp;Заказчик</translation>
    </message>
    <message>
        <source>Who brought the engine; the journal finds the job by it.</source>
        <translation>Кто привёз двигатель; по нему журнал находит работу.</translation>
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
        <source>“%1” is no date; write it like 2024-05-31.</source>
        <translation>«%1» — не дата; пишите так: 2024-05-31.</translation>
    </message>
    <message>
        <source>&amp;Technician</source>
        <translation>&amp;Исполнитель</translation>
    </message>
    <message>
        <source>Who does the work.</source>
        <translation>Кто выполняет работу.</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Вид работы</translation>
    </message>
    <message>
        <source>&amp;Engine</source>
        <translation>Дви&amp;гатель</translation>
    </message>
    <message>
        <source>Engines of the paper by displacement, then your own.</source>
        <translation>Двигатели статьи по рабочему объёму, затем свои.</translation>
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
        <source>In manufacture repair pistons and repair shells are not counted.</source>
        <translation>При изготовлении ремонтные поршни и вкладыши не учитываются.</translation>
    </message>
    <message>
        <source>Cran&amp;kshaft</source>
        <translation>&amp;Коленчатый вал</translation>
    </message>
    <message>
        <source>Which plugs the counterweights of the crankshaft were made for.</source>
        <translation>Под какие пробки сделаны противовесы вала.</translation>
    </message>
    <message>
        <source>Crankshaft</source>
        <translation>Коленчатый вал</translation>
    </message>
    <message>
        <source>Heavier than nominal by (negative: lighter)</source>
        <translation>Тяжелее номинала на (минус: легче)</translation>
    </message>
    <message>
        <source>&amp;Improved piston</source>
        <translation>&amp;Поршень</translation>
    </message>
    <message>
        <source>&amp;Rod big end</source>
        <translation>Н&amp;ижняя головка шатуна</translation>
    </message>
    <message>
        <source>Re&amp;pair piston and rings</source>
        <translation>Рем. пор&amp;шень с кольцами</translation>
    </message>
    <message>
        <source>Repair &amp;shells</source>
        <translation>Рем. вкл&amp;адыши</translation>
    </message>
    <message>
        <source>Δm_pi: one piston against nominal.</source>
        <translation>Δm_п: один поршень против номинала.</translation>
    </message>
    <message>
        <source>Δm_be: one big end against nominal.</source>
        <translation>Δm_шк: одна нижняя головка против номинала.</translation>
    </message>
    <message>
        <source>Δm_rp: one repair piston with its rings against nominal.</source>
        <translation>Δm_рп: один ремонтный поршень с кольцами против номинала.</translation>
    </message>
    <message>
        <source>Δm_sh: the repair shells of one crankpin against nominal.</source>
        <translation>Δm_шр: ремонтные вкладыши одной шейки против номинала.</translation>
    </message>
    <message>
        <source>Taken from the weigh-in sheet.</source>
        <translation>Взято с листа взвешивания.</translation>
    </message>
    <message>
        <source>Residual unbalance &amp;allowed</source>
        <translation>Допустимый дис&amp;баланс</translation>
    </message>
    <message>
        <source>In each correction plane. The paper accepts 5 g·mm.</source>
        <translation>В каждой плоскости коррекции. В статье 5 г·мм.</translation>
    </message>
</context>
<context>
    <name>ravnoves::Journal</name>
    <message>
        <source>The journal&apos;s folder %1 cannot be made.</source>
        <translation>Не удалось создать папку журнала %1.</translation>
    </message>
    <message>
        <source>The journal %1 cannot be opened: its folder cannot be written, or another program is busy with it.</source>
        <translation>Журнал %1 не открывается: в папку нельзя писать или журнал занят другой программой.</translation>
    </message>
    <message>
        <source>The journal was damaged. The damaged file was kept as %1, and a new journal was begun. Jobs taken over from it: %2.</source>
        <translation>Журнал был повреждён. Повреждённый файл сохранён как %1, начат новый журнал. Перенесено работ: %2.</translation>
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
        <source>%1 is a database of another program; it was left as it is.</source>
        <translation>%1 — база данных другой программы; файл не тронут.</translation>
    </message>
    <message>
        <source>The journal %1 is damaged and cannot be set aside; nothing was changed.</source>
        <translation>Журнал %1 повреждён, и его не удалось отложить; ничего не изменено.</translation>
    </message>
    <message>
        <source>The job could not be saved.</source>
        <translation>Работу не удалось сохранить.</translation>
    </message>
    <message>
        <source>The job could not be read.</source>
        <translation>Работу не удалось прочесть.</translation>
    </message>
    <message>
        <source>The job is no longer in the journal.</source>
        <translation>Этой работы в журнале уже нет.</translation>
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
        <source>The draft could not be saved.</source>
        <translation>Черновик не удалось сохранить.</translation>
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
        <source>The engine could not be saved.</source>
        <translation>Двигатель не удалось сохранить.</translation>
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
        <source>%1 could not be written.</source>
        <translation>Не удалось записать %1.</translation>
    </message>
    <message>
        <source>The engine could not be renamed.</source>
        <translation>Двигатель не удалось переименовать.</translation>
    </message>
    <message>
        <source>it is no longer kept</source>
        <translation>его больше нет в журнале</translation>
    </message>
</context>
<context>
    <name>ravnoves::JournalBanner</name>
    <message>
        <source>Continue it</source>
        <translation>Продолжить</translation>
    </message>
    <message>
        <source>Throw it away</source>
        <translation>Выбросить</translation>
    </message>
    <message>
        <source>Understood</source>
        <translation>Понятно</translation>
    </message>
    <message>
        <source>The program ended unexpectedly on %1 with an unfinished job (engine number: %2).</source>
        <translation>Программа неожиданно прервалась %1, осталась незаконченная работа (номер двигателя: %2).</translation>
    </message>
</context>
<context>
    <name>ravnoves::JournalDialog</name>
    <message>
        <source>“%1” is no date; write it like 2024-05-31.</source>
        <translation>«%1» — не дата; пишите так: 2024-05-31.</translation>
    </message>
    <message>
        <source>nothing needed</source>
        <translation>ничего не требуется</translation>
    </message>
    <message>
        <source>Journal of jobs</source>
        <translation>Журнал работ</translation>
    </message>
    <message>
        <source>engine number, customer, technician</source>
        <translation>номер двигателя, заказчик, исполнитель</translation>
    </message>
    <message>
        <source>&amp;Search</source>
        <translation>&amp;Поиск</translation>
    </message>
    <message>
        <source>any day</source>
        <translation>любой день</translation>
    </message>
    <message>
        <source>&amp;from</source>
        <translation>&amp;с</translation>
    </message>
    <message>
        <source>&amp;to</source>
        <translation>п&amp;о</translation>
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
        <source>Remove the job of engine %1 from the journal for good?</source>
        <translation>Удалить работу по двигателю %1 из журнала насовсем?</translation>
    </message>
    <message>
        <source>Export list</source>
        <translation>Выгрузка списка</translation>
    </message>
    <message>
        <source>CSV table (*.csv)</source>
        <translation>Таблица CSV (*.csv)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
    <message>
        <source>The newest %1 jobs; more match. The export has them all.</source>
        <translation>Последние работы: %1; найдено больше. В выгрузке будут все.</translation>
    </message>
</context>
<context>
    <name>ravnoves::MachineSheet</name>
    <message>
        <source>Permissible residual unbalance, ISO 21940-11</source>
        <translation>Допустимый остаточный дисбаланс, ИСО 21940-11</translation>
    </message>
    <message>
        <source>&amp;Grade G</source>
        <translation>&amp;Класс G</translation>
    </message>
    <message>
        <source>Balance quality grade. The standard&apos;s table has 0.4, 1, 2.5, 6.3, 16, 40, 100, 250, 630, 1600, 4000 mm/s; crankshaft drives of car, truck and locomotive engines G 100, inherently balanced crankshafts better.</source>
        <translation>Класс точности балансировки. В стандарте 0,4; 1; 2,5; 6,3; 16; 40; 100; 250; 630; 1600; 4000 мм/с; для кривошипных механизмов автомобильных и тепловозных двигателей G 100, для уравновешенных валов точнее.</translation>
    </message>
    <message>
        <source>&amp;Mass of the crankshaft</source>
        <translation>&amp;Масса вала</translation>
    </message>
    <message>
        <source>As it lies on the machine, with the bob weights.</source>
        <translation>Как лежит на станке, с грузами.</translation>
    </message>
    <message>
        <source>Service s&amp;peed</source>
        <translation>&amp;Частота вращения</translation>
    </message>
    <message>
        <source>The highest speed in service, not that of the machine.</source>
        <translation>Наибольшая рабочая, а не станка.</translation>
    </message>
    <message>
        <source>&amp;Share of the front plane</source>
        <translation>&amp;Доля передней плоскости</translation>
    </message>
    <message>
        <source>Half for a crankshaft whose mass lies midway between the planes; the standard allows 0.3 to 0.7.</source>
        <translation>Половина, если центр масс посередине между плоскостями; стандарт допускает 0,3–0,7.</translation>
    </message>
    <message>
        <source>What the machine reads</source>
        <translation>Показания станка</translation>
    </message>
    <message>
        <source>&amp;Front plane (pulley)</source>
        <translation>&amp;Передняя плоскость (шкив)</translation>
    </message>
    <message>
        <source>Residual unbalance after correction.</source>
        <translation>Остаточный дисбаланс после исправления.</translation>
    </message>
    <message>
        <source>&amp;Rear plane (flywheel)</source>
        <translation>&amp;Задняя плоскость (маховик)</translation>
    </message>
    <message>
        <source>Correction planes</source>
        <translation>Плоскости коррекции</translation>
    </message>
    <message>
        <source>Notes on the job card</source>
        <translation>Примечания для карты</translation>
    </message>
    <message>
        <source>&amp;Notes</source>
        <translation>П&amp;римечания</translation>
    </message>
    <message>
        <source>Printed on the job card.</source>
        <translation>Печатается на карте.</translation>
    </message>
</context>
<context>
    <name>ravnoves::MainWindow</name>
    <message>
        <source>%1: this page is still to come.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open case…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save case &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save page as &amp;picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy results as &amp;text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results copied as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy results as &amp;CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results copied as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset &amp;zoom of all plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>L&amp;anguage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language changes when the program starts again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About this page: formulas and sources</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Case files and command line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About &amp;Ravnoves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Main toolbar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the page for “%2” is still to come.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes of “%1”?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open case</source>
        <translation type="unfinished">Открытие задачи</translation>
    </message>
    <message>
        <source>Ravnoves cases (*.case.json *.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ravnoves cases (*.case.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save page as picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Ravnoves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;h3&gt;Ravnoves %1&lt;/h3&gt;&lt;p&gt;The engine-balancing workbench.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later; it comes without any warranty.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::MechanismView</name>
    <message>
        <source>Front view of the mechanism</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front view to scale; the crank turns clockwise. Drag the shaft to change α, drag elsewhere to turn the crank, Space plays and pauses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>φ = %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pⱼ₁</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P₁ crank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P₁ shaft</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::NumberField</name>
    <message>
        <source>A value is needed: %1.</source>
        <translation>Нужно значение: %1.</translation>
    </message>
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
</context>
<context>
    <name>ravnoves::NumberListField</name>
    <message>
        <source>“%1” is not a number.</source>
        <translation type="unfinished">«%1» — не число.</translation>
    </message>
    <message>
        <source>The value %1.</source>
        <translation type="unfinished">Значение %1.</translation>
    </message>
    <message numerus="yes">
        <source>At most %n value(s).</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Each value %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::OrderBars</name>
    <message>
        <source>Amplitudes by order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two-term</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F, N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M, N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mz, N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing in any order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order %1: exact %2, two-term %3, left over %4</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::OrdersView</name>
    <message>
        <source>Order spectrum of the moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>order (per turn of the crank)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without a shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the shaft at the present α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A four-stroke cycle has half orders. A shaft at crank speed changes order 1 alone; the best RMS is where it opposes that order.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order spectrum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mᵤₚ, N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phase, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mᵤₚₛ, N·m</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::PlotView</name>
    <message>
        <source>Show %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset zoom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy data as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG picture (*.png);;SVG drawing (*.svg)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::PlugSizesSheet</name>
    <message>
        <source>Plug</source>
        <translation>Пробка</translation>
    </message>
    <message>
        <source>&amp;Height h</source>
        <translation>&amp;Высота h</translation>
    </message>
    <message>
        <source>Of the whole plug.</source>
        <translation>Всей пробки.</translation>
    </message>
    <message>
        <source>&amp;Bore diameter</source>
        <translation>&amp;Диаметр полости</translation>
    </message>
    <message>
        <source>Of the bore that is there. Empty: a solid plug.</source>
        <translation>Имеющейся полости. Пусто: сплошная пробка.</translation>
    </message>
    <message>
        <source>Bore de&amp;pth</source>
        <translation>&amp;Глубина полости</translation>
    </message>
    <message>
        <source>From the outer face. Empty: a solid plug.</source>
        <translation>От наружного торца. Пусто: сплошная пробка.</translation>
    </message>
    <message>
        <source>Boring</source>
        <translation>Расточка</translation>
    </message>
    <message>
        <source>&amp;Cutter diameter</source>
        <translation>Диаметр &amp;фрезы</translation>
    </message>
    <message>
        <source>Empty: no boring is planned.</source>
        <translation>Пусто: расточка не считается.</translation>
    </message>
    <message>
        <source>&amp;Wall that must stay</source>
        <translation>&amp;Стенка не меньше</translation>
    </message>
    <message>
        <source>Between the bore and the root of the thread. Empty: no limit.</source>
        <translation>Между полостью и впадиной резьбы. Пусто: без предела.</translation>
    </message>
    <message>
        <source>B&amp;ottom that must stay</source>
        <translation>Д&amp;но не меньше</translation>
    </message>
    <message>
        <source>Between the bore and the inner face. Empty: no limit.</source>
        <translation>Между полостью и внутренним торцом. Пусто: без предела.</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Плотность</translation>
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
        <source>&amp;Thread</source>
        <translation>&amp;Резьба</translation>
    </message>
    <message>
        <source>Metric thread with its pitch, like M22x1.5.</source>
        <translation>Метрическая резьба с шагом, например M22x1.5.</translation>
    </message>
    <message>
        <source>“%1” is no metric thread with its pitch, like M22x1.5.</source>
        <translation>«%1» — не метрическая резьба с шагом, как M22x1.5.</translation>
    </message>
</context>
<context>
    <name>ravnoves::PlugView</name>
    <message>
        <source>Plug in section</source>
        <translation>Пробка в разрезе</translation>
    </message>
    <message>
        <source>Plug</source>
        <translation>Пробка</translation>
    </message>
    <message>
        <source>not to scale: sizes on the sheet “Plug”</source>
        <translation>без масштаба: размеры — на листе «Пробка»</translation>
    </message>
</context>
<context>
    <name>ravnoves::Range</name>
    <message>
        <source>must be greater than %1 and less than %2</source>
        <translation>должно быть больше %1 и меньше %2</translation>
    </message>
    <message>
        <source>must be greater than %1 and at most %2</source>
        <translation>должно быть больше %1 и не больше %2</translation>
    </message>
    <message>
        <source>must be at least %1 and less than %2</source>
        <translation>должно быть не меньше %1 и меньше %2</translation>
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
        <source>must be less than %1</source>
        <translation>должно быть меньше %1</translation>
    </message>
    <message>
        <source>must be at most %1</source>
        <translation>должно быть не больше %1</translation>
    </message>
</context>
<context>
    <name>ravnoves::RelievedShaftDrawing</name>
    <message>
        <source>Drawing of the shaft with a relieved middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No shaft of these sizes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::RelievedShaftView</name>
    <message>
        <source>Shaft with a relieved middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size that follows from the others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length b</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>diameter D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing, only check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two sizes are given, the third follows from the unbalance m₁ ρ₁.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Diameter D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the round bar; also the circle that the shaft sweeps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth &amp;h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the segment that is milled away, from the bar&apos;s surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Length b</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over which the segment is milled away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Densit&amp;y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the bar. Steel 7850, cast iron 7200, tungsten alloy 17500.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density</source>
        <translation type="unfinished">Плотность</translation>
    </message>
    <message>
        <source>&amp;Elastic modulus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For the sag under the shaft&apos;s own centrifugal load. Steel 210, cast iron 170, tungsten alloy 360.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elastic modulus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xport drawing (DXF)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section and side view, real size, for the machine shop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sizes and masses of the shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relieved shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size to find</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished">мм</translation>
    </message>
    <message>
        <source>unbalance needed, m₁ ρ₁</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>g·mm</source>
        <translation type="unfinished">г·мм</translation>
    </message>
    <message>
        <source>unbalance of the shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>width of the flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mass of the relieved part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kg</source>
        <translation type="unfinished">кг</translation>
    </message>
    <message>
        <source>mass milled away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius of its centre of mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>critical bar radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>critical length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sag at speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bending stress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MPa</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The smallest bar that can have the unbalance at this length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shortest relief that can have it with this bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the relieved part on two supports under its own centrifugal load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feasible, but more than half of the bar is milled away: a depth of %1 mm gives the same unbalance and a stiffer shaft.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feasible.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These sizes give %1 % of the unbalance that is needed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bar is too thin: its diameter must be at least %1 mm, or the relieved length at least %2 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no such shaft: no unbalance is needed, or it is beyond these sizes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DXF drawings (*.dxf)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::ResultTable</name>
    <message>
        <source>Copy selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy table as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy table as CSV</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::SceneList</name>
    <message>
        <source>Balance shaft</source>
        <translation>Урав. вал</translation>
    </message>
    <message>
        <source>Where the balance shaft of a single-cylinder engine goes</source>
        <translation>Где поставить уравновешивающий вал одноцилиндрового двигателя</translation>
    </message>
    <message>
        <source>Elastic hinges</source>
        <translation>Шарниры</translation>
    </message>
    <message>
        <source>Spring guides that hold the crank speed constant</source>
        <translation>Пружинные направляющие, удерживающие частоту вращения постоянной</translation>
    </message>
    <message>
        <source>V-8 workshop</source>
        <translation>Ремонт V-8</translation>
    </message>
    <message>
        <source>Crankpin plugs and bob weights of a V-8 under repair</source>
        <translation>Пробки шатунных шеек и балансировочные грузы при ремонте V-8</translation>
    </message>
    <message>
        <source>Inertia moments</source>
        <translation>Моменты</translation>
    </message>
    <message>
        <source>Forces and moments of VR5 and any other cylinder layout</source>
        <translation>Силы и моменты VR5 и любой другой компоновки</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Методы</translation>
    </message>
    <message>
        <source>Speed against accuracy, and where methods fail</source>
        <translation>Скорость против точности и где методы отказывают</translation>
    </message>
</context>
<context>
    <name>ravnoves::ShaftRow</name>
    <message>
        <source>Shaft %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switched on, the shaft counts in what is left over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order that the shaft cancels; it turns k times as fast as the crank. 1 to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order of the shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+kω</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>−kω</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the crank (+kω) or against it (−kω)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction of the shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Task of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two opposite weights against a moment, one against a force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Task of the shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of the weights of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;ρ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the weights of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the weights&apos; centres of mass; gives their mass. Empty: only mρ is given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;δ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error of phase of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error of the shaft&apos;s phase, ahead in its own direction: 0 when it is timed right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place of the shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the shaft&apos;s weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phase of the shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>c. m.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance between the two weights along the shaft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axial position of the weight; empty: at the point that moments refer to</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::ShaftView</name>
    <message>
        <source>Balance shafts: arrangement and phases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each shaft seen from the front at the present crank angle. Red: what it cancels; the weights lie opposite. Dashed: cylinder 1&apos;s axis and crankpin 1. Click a shaft to switch it; arrow keys and Space do the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No balance shafts. “Add shaft” under Balancing makes one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N·m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mρ %1 g·mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>m %1 g</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 → %2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing to cancel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::ShiftPlot</name>
    <message>
        <source>Shift of the plug&apos;s centre of mass</source>
        <translation>Смещение центра масс пробки</translation>
    </message>
    <message>
        <source>Coefficient Δk over the shift Δr for five crank radii</source>
        <translation>Коэффициент Δk от смещения Δr для пяти радиусов кривошипа</translation>
    </message>
    <message>
        <source>Δr, mm</source>
        <translation>Δr, мм</translation>
    </message>
    <message>
        <source>Δk</source>
        <translation>Δk</translation>
    </message>
    <message>
        <source>r = %1: %2</source>
        <translation>r = %1: %2</translation>
    </message>
    <message>
        <source>this engine</source>
        <translation>этот двигатель</translation>
    </message>
    <message>
        <source>neglected</source>
        <translation>не учтено</translation>
    </message>
</context>
<context>
    <name>ravnoves::SpeedView</name>
    <message>
        <source>Speed &amp;n</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>min⁻¹</source>
        <translation type="unfinished">мин⁻¹</translation>
    </message>
    <message>
        <source>Speed of the engine; the inertia torque of a computed torque follows it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Load, IMEP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Indicated mean effective pressure of the computed cycle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Band from, min⁻¹</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Band to, min⁻¹</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;to</source>
        <translation type="unfinished">п&amp;о</translation>
    </message>
    <message>
        <source>range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Criterion of the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Map of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Best α over speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α of the least range at each speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α of the least RMS at each speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map over α and speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>n, min⁻¹</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>best α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the α that is least bad over the band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled. Any change of the input solves again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The load can be moved when the torque is a computed cycle (Torque tab).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shaft cannot be studied over speed with this torque: it is a table that does not belong to the masses and speed entered, so the part that follows the speed is not known. Rebuild it (Torque tab) or choose a pressure trace or a computed cycle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>least bad %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least bad α over the band, by the %1 against the engine without a shaft: %2°. At its worst speed, %3 min⁻¹, the %1 is %4 % %5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ÷ without: %2…%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The criterion with the shaft over that without it at the same speed; dark is small, light is large. Click to set α and, with a computed torque, the speed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::TorqueSourceEditor</name>
    <message>
        <source>table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pressure trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>computed cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tor&amp;que from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A table is taken as it is. From a pressure trace or a computed cycle the torque is gas torque plus inertia torque of the masses and speed entered, so it follows both.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Bore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter of the cylinder. TMZ-650D: 95.5 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>O&amp;ffset e</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of the cylinder axis from the crank axis, positive on the side to which the crankpin moves first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crankcase &amp;pressure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Absolute pressure under the piston, p₀.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use its speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set the speed at which the masses entered have the inertia torque that is in the table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rebuild torque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the fitted inertia torque out of the table and put that of the masses and speed entered in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the torque&apos;s speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No inertia torque can be read off this table, so it cannot be checked against the masses and speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This torque does not belong to the masses and speed entered. On its gas-exchange stroke it holds mⱼ r² ω² = %1 N·m (λ %2); entered are %3 N·m. It would fit %4 min⁻¹ with these masses, or %5 kg at this speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The inertia torque in this table fits the masses and speed: mⱼ r² ω² = %1 N·m against %2 N·m entered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured cylinder pressure over 720° as a CSV file: crank angle from top dead centre before intake, absolute pressure (bar unless the heading says kPa, MPa, Pa or psi).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Read CSV file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation type="unfinished">Цилиндр</translation>
    </message>
    <message>
        <source>The rod length is on the Inputs tab.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read pressure trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt *.tsv);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A plain four-stroke cycle: constant pressures for gas exchange, polytropic compression, one Wiebe heat release, polytropic expansion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gas exchange and compression</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compression &amp;ratio ε</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest over smallest volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Intake pressure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Absolute, constant over intake.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xhaust pressure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Absolute, constant over exhaust.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exponent, &amp;compression</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polytropic exponent until combustion begins; about 1.32 to 1.38.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exponent, ex&amp;pansion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polytropic exponent of combustion and expansion; about 1.22 to 1.32.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Combustion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I&amp;MEP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Indicated mean effective pressure over 720°; the heat that gives it is found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Heat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heat released per cycle; instead of the IMEP.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Start of combustion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank angle; 360° is the firing top dead centre.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crank angle from the start to the end of heat release.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Wiebe exponent m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Form exponent of Wiebe&apos;s law; 0.5 to 1.5 for diesels, 2 to 4 for petrol engines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation type="unfinished">%1: %2.</translation>
    </message>
</context>
<context>
    <name>ravnoves::TorqueTableEditor</name>
    <message>
        <source>Engine torque over one four-stroke cycle, 720°. Paste a whole table from a spreadsheet, or type.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import CSV file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import torque table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt *.tsv);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export CSV file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export torque table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV tables (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy (Ctrl+C)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert a row below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the selected rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit torque table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last valid table holds until this is mended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clipboard holds no table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not pasted: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::TorqueTableModel</name>
    <message>
        <source>Row %1: “%2” is not a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>φ, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M_id, N·m</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::V8PlugsPage</name>
    <message>
        <source>The unfinished job is on the sheet again.</source>
        <translation>Незаконченная работа снова на листе.</translation>
    </message>
    <message>
        <source>Unfinished job</source>
        <translation>Незаконченная работа</translation>
    </message>
    <message>
        <source>&amp;3 Weigh-in</source>
        <translation>&amp;3 Весы</translation>
    </message>
    <message>
        <source>&amp;1 Job</source>
        <translation>&amp;1 Работа</translation>
    </message>
    <message>
        <source>&amp;2 Engine</source>
        <translation>&amp;2 Двигатель</translation>
    </message>
    <message>
        <source>&amp;4 Plug</source>
        <translation>&amp;4 Пробка</translation>
    </message>
    <message>
        <source>&amp;5 Machine</source>
        <translation>&amp;5 Станок</translation>
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
        <source>&amp;Next job</source>
        <translation>С&amp;ледующая работа</translation>
    </message>
    <message>
        <source>Next job: the engine&apos;s values stay, the rest is empty</source>
        <translation>Следующая работа: данные двигателя остаются, остальное пусто</translation>
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
        <source>Look at the job card</source>
        <translation>Посмотреть карту</translation>
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
        <source>Journal</source>
        <translation>Журнал</translation>
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
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Записано: %1</translation>
    </message>
    <message>
        <source>Refused entries</source>
        <translation>Непринятые значения</translation>
    </message>
    <message>
        <source>These entries were refused; the values before them count:</source>
        <translation>Эти значения не приняты; действуют прежние:</translation>
    </message>
</context>
<context>
    <name>ravnoves::V8PlugsViewModel</name>
    <message>
        <source>Open case</source>
        <translation>Открытие задачи</translation>
    </message>
    <message>
        <source>New case</source>
        <translation>Новая задача</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Двигатель</translation>
    </message>
    <message>
        <source>The engine needs a name.</source>
        <translation>Двигателю нужно название.</translation>
    </message>
    <message>
        <source>“%1” is the name of a preset; choose another.</source>
        <translation>«%1» — название встроенного двигателя; выберите другое.</translation>
    </message>
    <message>
        <source>Save engine</source>
        <translation>Запомнить двигатель</translation>
    </message>
    <message>
        <source>The paper gives only the crank radius of this engine; the rest has to be measured.</source>
        <translation>Для этого двигателя статья даёт только радиус кривошипа; остальное нужно измерить.</translation>
    </message>
    <message>
        <source>Plug masses as the paper prints them. They look too small for the threads it prints: weigh the plugs and type what the scale says.</source>
        <translation>Массы пробок — как напечатано в статье. Для напечатанных резьб они слишком малы: взвесьте пробки и введите показания весов.</translation>
    </message>
    <message>
        <source>The values do not go together.</source>
        <translation>Значения не согласуются.</translation>
    </message>
    <message>
        <source>Still needed: %1.</source>
        <translation>Ещё нужны: %1.</translation>
    </message>
    <message>
        <source>Excess Δm_y: not known yet</source>
        <translation>Δm_у: пока неизвестна</translation>
    </message>
    <message>
        <source>Excess Δm_y: %1, %2</source>
        <translation>Δm_у: %1, %2</translation>
    </message>
    <message>
        <source>The bob weight still needs: %1.</source>
        <translation>Для груза ещё нужны: %1.</translation>
    </message>
    <message>
        <source>ISO 21940-11 needs grade, mass and speed.</source>
        <translation>Для ИСО 21940-11 нужны класс, масса и частота вращения.</translation>
    </message>
    <message>
        <source>ISO 21940-11: U_per = 1000 m G / ω = %1 for the whole crankshaft; the method&apos;s own limit is %2 in each plane.</source>
        <translation>ИСО 21940-11: U_доп = 1000 m G / ω = %1 на весь вал; предел самого метода — %2 в каждой плоскости.</translation>
    </message>
    <message>
        <source>With thread and height the sheet says what the plug would weigh.</source>
        <translation>По резьбе и высоте лист скажет, сколько весила бы пробка.</translation>
    </message>
    <message>
        <source>A plug of these dimensions weighs %1 in steel, %2 in aluminium.</source>
        <translation>Пробка таких размеров весит %1 из стали, %2 из алюминия.</translation>
    </message>
    <message>
        <source>Option</source>
        <translation>Вариант</translation>
    </message>
    <message>
        <source>const., g</source>
        <translation>пост., г</translation>
    </message>
    <message>
        <source>reach, g</source>
        <translation>предел, г</translation>
    </message>
    <message>
        <source>needed, g</source>
        <translation>снять, г</translation>
    </message>
    <message>
        <source>left, g·mm</source>
        <translation>ост., г·мм</translation>
    </message>
    <message>
        <source>The engine has no such plug, or its data are missing.</source>
        <translation>Такой пробки у двигателя нет или нет её данных.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>At most %1 may come off a plug; slope k_y = %2, %3°.</source>
        <translation>С пробки можно снять не больше %1; наклон k_у = %2, %3°.</translation>
    </message>
    <message>
        <source>factor × mass, g</source>
        <translation>коэфф. × масса, г</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>номинал</translation>
    </message>
    <message>
        <source>before</source>
        <translation>до</translation>
    </message>
    <message>
        <source>after</source>
        <translation>после</translation>
    </message>
    <message>
        <source>Bob weight</source>
        <translation>Груз</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Плоскость</translation>
    </message>
    <message>
        <source>allowed, g·mm</source>
        <translation>допустимо, г·мм</translation>
    </message>
    <message>
        <source>reading, g·mm</source>
        <translation>показание, г·мм</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>вывод</translation>
    </message>
    <message>
        <source>✓ passes</source>
        <translation>✓ годен</translation>
    </message>
    <message>
        <source>✗ fails</source>
        <translation>✗ не годен</translation>
    </message>
    <message>
        <source>Front (pulley)</source>
        <translation>Передняя (шкив)</translation>
    </message>
    <message>
        <source>Rear (flywheel)</source>
        <translation>Задняя (маховик)</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Цилиндр</translation>
    </message>
    <message>
        <source>Piston from</source>
        <translation>Поршень из</translation>
    </message>
    <message>
        <source>Rod from</source>
        <translation>Шатун из</translation>
    </message>
    <message>
        <source>Crankpin</source>
        <translation>Шейка</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>разброс</translation>
    </message>
    <message>
        <source>as weighed, g</source>
        <translation>как есть, г</translation>
    </message>
    <message>
        <source>after moving, g</source>
        <translation>после, г</translation>
    </message>
    <message>
        <source>%1: %2 weighed; heaviest in cylinder %3, lightest in cylinder %4.</source>
        <translation>%1: взвешено %2; тяжелее всех в цилиндре %3, легче всех в цилиндре %4.</translation>
    </message>
    <message>
        <source>There is no journal.</source>
        <translation>Журнала нет.</translation>
    </message>
    <message>
        <source>without an engine number</source>
        <translation>без номера двигателя</translation>
    </message>
    <message>
        <source>Job %1 had been changed elsewhere meanwhile: saved as a new job.</source>
        <translation>Работу %1 тем временем изменили в другом месте: сохранено как новая работа.</translation>
    </message>
    <message>
        <source>Job %1 saved in the journal.</source>
        <translation>Работа %1 сохранена в журнале.</translation>
    </message>
    <message>
        <source>The job&apos;s sheet cannot be read: %1</source>
        <translation>Лист работы не читается: %1</translation>
    </message>
    <message>
        <source>The values kept for the engine “%1” cannot be read: %2</source>
        <translation>Сохранённые данные двигателя «%1» не читаются: %2</translation>
    </message>
    <message>
        <source>“%1” is the name of another engine of your own; choose another.</source>
        <translation>Имя «%1» уже носит другой ваш двигатель; выберите иное.</translation>
    </message>
    <message>
        <source>Rename engine</source>
        <translation>Переименование двигателя</translation>
    </message>
    <message>
        <source>The values differ from those kept under this name; “Keep as own engine” keeps these.</source>
        <translation>Данные отличаются от сохранённых под этим именем; «Запомнить двигатель» сохранит эти.</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>наклон</translation>
    </message>
    <message>
        <source>left, g</source>
        <translation>ост., г</translation>
    </message>
    <message>
        <source>For the other crankshaft.</source>
        <translation>Для другого вала.</translation>
    </message>
</context>
<context>
    <name>ravnoves::WeighInSheet</name>
    <message>
        <source>Take the mass changes &amp;from this sheet</source>
        <translation>Брать изменения масс с &amp;этого листа</translation>
    </message>
    <message>
        <source>Off: the changes typed on the sheet “Job” count.</source>
        <translation>Выключено: действуют изменения, введённые на листе «Работа».</translation>
    </message>
    <message>
        <source>C&amp;ylinders of a crankpin</source>
        <translation>&amp;Цилиндры одной шейки</translation>
    </message>
    <message>
        <source>1 and 5, 2 and 6, … (bank by bank)</source>
        <translation>1 и 5, 2 и 6, … (по рядам)</translation>
    </message>
    <message>
        <source>1 and 2, 3 and 4, …</source>
        <translation>1 и 2, 3 и 4, …</translation>
    </message>
    <message>
        <source>Which two cylinders share a crankpin.</source>
        <translation>Какие два цилиндра сидят на одной шатунной шейке.</translation>
    </message>
    <message>
        <source>Cylinders of a crankpin</source>
        <translation>Цилиндры одной шейки</translation>
    </message>
    <message>
        <source>nominal, g</source>
        <translation>номинал, г</translation>
    </message>
    <message>
        <source>permitted spread, g</source>
        <translation>допустимый разброс, г</translation>
    </message>
    <message>
        <source>mean, g</source>
        <translation>среднее, г</translation>
    </message>
    <message>
        <source>spread, g</source>
        <translation>разброс, г</translation>
    </message>
    <message>
        <source>%1, nominal mass, g</source>
        <translation>%1, номинальная масса, г</translation>
    </message>
    <message>
        <source>%1: mass by the drawing.</source>
        <translation>%1: масса по чертежу.</translation>
    </message>
    <message>
        <source>%1, permitted spread, g</source>
        <translation>%1, допустимый разброс, г</translation>
    </message>
    <message>
        <source>%1: heaviest less lightest that the works manual permits. Empty: no limit.</source>
        <translation>%1: наибольшая минус наименьшая масса по руководству. Пусто: без предела.</translation>
    </message>
    <message>
        <source>%1 of cylinder %2, g</source>
        <translation>%1, цилиндр %2, г</translation>
    </message>
    <message>
        <source>%1 of cylinder %2 as the scale says.</source>
        <translation>%1, цилиндр %2, по весам.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1, nominal</source>
        <translation>%1, номинал</translation>
    </message>
    <message>
        <source>%1, spread</source>
        <translation>%1, разброс</translation>
    </message>
    <message>
        <source>Excess on each crankpin, as weighed and after moving</source>
        <translation>Лишняя масса на каждой шейке: как взвешено и после перестановки</translation>
    </message>
    <message>
        <source>Which set goes to which cylinder</source>
        <translation>Какой комплект в какой цилиндр</translation>
    </message>
    <message>
        <source>Source of the mass changes</source>
        <translation>Источник изменений масс</translation>
    </message>
    <message>
        <source>to nominal, g</source>
        <translation>к номиналу, г</translation>
    </message>
    <message>
        <source>&amp;Move them here</source>
        <translation>Пере&amp;ставить здесь</translation>
    </message>
    <message>
        <source>The weights change places on this sheet as the parts do.</source>
        <translation>Массы на этом листе меняются местами, как и детали.</translation>
    </message>
    <message>
        <source>Move parts</source>
        <translation>Перестановка деталей</translation>
    </message>
</context>
</TS>
