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
        <source>Hang on each crankpin: %1</source>
        <translation>Груз на каждую шейку: %1</translation>
    </message>
    <message>
        <source>Which set goes to which cylinder</source>
        <translation>Какой комплект в какой цилиндр</translation>
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
        <source>Shaft s&amp;wing radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circle swept by the balance shaft. Empty: 1.3 ρ₁.</source>
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
        <source>Torque table</source>
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
        <source> (with %1 kg not listed)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ravnoves::BalanceShaftViewModel</name>
    <message>
        <source>Open case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New case</source>
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
        <source>mean, nodes</source>
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
        <translation type="unfinished"></translation>
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
        <source>Every α is as good as any other.</source>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value %1.</source>
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
    <name>ravnoves::Range</name>
    <message>
        <source>must be greater than %1 and less than %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be greater than %1 and at most %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be at least %1 and less than %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be greater than %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be at least %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be less than %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>must be at most %1</source>
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
</TS>
