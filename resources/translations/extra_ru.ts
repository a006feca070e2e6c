<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru_RU">
<context>
    <name>Keys</name>
    <message>
        <source>angle</source>
        <translation>угол</translation>
    </message>
    <message>
        <source>angular speed</source>
        <translation>угловая скорость</translation>
    </message>
    <message>
        <source>articulated</source>
        <translation>прицепной шатун</translation>
    </message>
    <message>
        <source>axial position</source>
        <translation>положение вдоль вала</translation>
    </message>
    <message>
        <source>balance shafts</source>
        <translation>балансирные валы</translation>
    </message>
    <message>
        <source>balancing</source>
        <translation>балансировка</translation>
    </message>
    <message>
        <source>bank angle</source>
        <translation>угол ряда</translation>
    </message>
    <message>
        <source>correction</source>
        <translation>корректировка</translation>
    </message>
    <message>
        <source>counterweights</source>
        <translation>противовесы</translation>
    </message>
    <message>
        <source>crank angle</source>
        <translation>угол кривошипа</translation>
    </message>
    <message>
        <source>crankpin angle</source>
        <translation>угол колена</translation>
    </message>
    <message>
        <source>crankshaft number</source>
        <translation>номер вала</translation>
    </message>
    <message>
        <source>customer</source>
        <translation>заказчик</translation>
    </message>
    <message>
        <source>cycle</source>
        <translation>расчётный цикл</translation>
    </message>
    <message>
        <source>cylinder numbering</source>
        <translation>нумерация цилиндров</translation>
    </message>
    <message>
        <source>cylinders</source>
        <translation>цилиндры</translation>
    </message>
    <message>
        <source>date</source>
        <translation>дата</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>расстояние</translation>
    </message>
    <message>
        <source>drill</source>
        <translation>свёрла</translation>
    </message>
    <message>
        <source>earlier runs</source>
        <translation>прежние пуски</translation>
    </message>
    <message>
        <source>enabled</source>
        <translation>включено</translation>
    </message>
    <message>
        <source>engine</source>
        <translation>двигатель</translation>
    </message>
    <message>
        <source>engine number</source>
        <translation>номер двигателя</translation>
    </message>
    <message>
        <source>engine overrides</source>
        <translation>отличия от двигателя</translation>
    </message>
    <message>
        <source>envelope</source>
        <translation>габарит</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>коэффициент балансировки</translation>
    </message>
    <message>
        <source>flywheel</source>
        <translation>маховик</translation>
    </message>
    <message>
        <source>free length</source>
        <translation>свободная длина</translation>
    </message>
    <message>
        <source>gears</source>
        <translation>шестерни</translation>
    </message>
    <message>
        <source>guide radius at zero</source>
        <translation>радиус направляющей при 0°</translation>
    </message>
    <message>
        <source>guide search</source>
        <translation>подбор направляющей</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>момент инерции</translation>
    </message>
    <message>
        <source>job</source>
        <translation>работа</translation>
    </message>
    <message>
        <source>knuckle angle</source>
        <translation>угол пальца прицепа</translation>
    </message>
    <message>
        <source>knuckle mass</source>
        <translation>масса у пальца прицепа</translation>
    </message>
    <message>
        <source>knuckle radius</source>
        <translation>радиус пальца прицепа</translation>
    </message>
    <message>
        <source>layout</source>
        <translation>компоновка</translation>
    </message>
    <message>
        <source>map</source>
        <translation>карта</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>масса</translation>
    </message>
    <message>
        <source>mass changes</source>
        <translation>изменения масс</translation>
    </message>
    <message>
        <source>masses</source>
        <translation>массы</translation>
    </message>
    <message>
        <source>master</source>
        <translation>главный шатун</translation>
    </message>
    <message>
        <source>matching</source>
        <translation>подбор деталей</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>движение</translation>
    </message>
    <message>
        <source>nominal</source>
        <translation>номинал</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>примечания</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>дезаксаж</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>детали</translation>
    </message>
    <message>
        <source>pin</source>
        <translation>палец</translation>
    </message>
    <message>
        <source>piston</source>
        <translation>поршень</translation>
    </message>
    <message>
        <source>piston sets</source>
        <translation>комплекты поршней</translation>
    </message>
    <message>
        <source>place limits</source>
        <translation>границы места</translation>
    </message>
    <message>
        <source>planes</source>
        <translation>плоскости</translation>
    </message>
    <message>
        <source>plug</source>
        <translation>заглушка</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>давление</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>показания</translation>
    </message>
    <message>
        <source>reciprocating mass</source>
        <translation>поступательная масса</translation>
    </message>
    <message>
        <source>reciprocating masses</source>
        <translation>поступательные массы</translation>
    </message>
    <message>
        <source>relieved shaft</source>
        <translation>вал с лыской</translation>
    </message>
    <message>
        <source>rings</source>
        <translation>кольца</translation>
    </message>
    <message>
        <source>rod</source>
        <translation>шатун</translation>
    </message>
    <message>
        <source>rod big end</source>
        <translation>нижняя головка</translation>
    </message>
    <message>
        <source>rod counterweight</source>
        <translation>противовес на шатуне</translation>
    </message>
    <message>
        <source>rod hinge spring</source>
        <translation>пружина шарнира шатуна</translation>
    </message>
    <message>
        <source>rod length</source>
        <translation>длина шатуна</translation>
    </message>
    <message>
        <source>rod sets</source>
        <translation>комплекты шатунов</translation>
    </message>
    <message>
        <source>rod small end</source>
        <translation>верхняя головка</translation>
    </message>
    <message>
        <source>shaft angle</source>
        <translation>угол вала</translation>
    </message>
    <message>
        <source>shells</source>
        <translation>вкладыши</translation>
    </message>
    <message>
        <source>slug</source>
        <translation>вставка</translation>
    </message>
    <message>
        <source>solve</source>
        <translation>найти</translation>
    </message>
    <message>
        <source>speed band</source>
        <translation>диапазон частот</translation>
    </message>
    <message>
        <source>speeds</source>
        <translation>частоты вращения</translation>
    </message>
    <message>
        <source>spring</source>
        <translation>пружина</translation>
    </message>
    <message>
        <source>step</source>
        <translation>шаг</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>жёсткость</translation>
    </message>
    <message>
        <source>technician</source>
        <translation>исполнитель</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>допуск</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>крутящий момент</translation>
    </message>
    <message>
        <source>unbalance</source>
        <translation>дисбаланс</translation>
    </message>
    <message>
        <source>weigh in</source>
        <translation>взвешивание</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>вес</translation>
    </message>
    <message>
        <source>weights</source>
        <translation>веса</translation>
    </message>
    <message>
        <source>front read of</source>
        <translation>чьё показание спереди</translation>
    </message>
    <message>
        <source>read of</source>
        <translation>чьи показания</translation>
    </message>
    <message>
        <source>rear read of</source>
        <translation>чьё показание сзади</translation>
    </message>
    <message>
        <source>file</source>
        <translation>файл</translation>
    </message>
    <message>
        <source>format</source>
        <translation>формат</translation>
    </message>
    <message>
        <source>input</source>
        <translation>входные данные</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>сохранённое</translation>
    </message>
    <message>
        <source>method</source>
        <translation>метод</translation>
    </message>
    <message>
        <source>name</source>
        <translation>имя</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>выборка</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>модуль</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>начальное число</translation>
    </message>
    <message>
        <source>study</source>
        <translation>исследование</translation>
    </message>
    <message>
        <source>title</source>
        <translation>название</translation>
    </message>
    <message>
        <source>variants</source>
        <translation>варианты</translation>
    </message>
    <message>
        <source>vary</source>
        <translation>разброс</translation>
    </message>
    <message>
        <source>version</source>
        <translation>версия</translation>
    </message>
    <message>
        <source>watch</source>
        <translation>наблюдаемое</translation>
    </message>
    <message>
        <source>drilled</source>
        <translation>просверлено</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>план</translation>
    </message>
    <message>
        <source>drilled by</source>
        <translation>просверлено по показаниям</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>цилиндр</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>станок</translation>
    </message>
    <message>
        <source>plugs</source>
        <translation>заглушки</translation>
    </message>
    <message>
        <source>permitted spread</source>
        <translation>допустимый разброс</translation>
    </message>
    <message>
        <source>drilled counting otherwise</source>
        <translation>просверлено при другом отсчёте углов</translation>
    </message>
</context>
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>Folder</source>
        <comment>All other platforms</comment>
        <translation>Папка</translation>
    </message>
    <message>
        <source>File Folder</source>
        <comment>Match Windows Explorer</comment>
        <translation>Папка с файлами</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <comment>All other platforms</comment>
        <translation>Ярлык</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Диск</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Неизвестно</translation>
    </message>
</context>
<context>
    <name>ravnoves::Presets</name>
    <message>
        <source>TMZ-650D</source>
        <translation>ТМЗ-650Д</translation>
    </message>
</context>
</TS>
