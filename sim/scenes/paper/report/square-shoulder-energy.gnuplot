set terminal svg size 760,500 dynamic enhanced font 'sans-serif,14' background '#ffffff'
set encoding utf8
set linetype 1 lc rgb '#0072b2' lw 2.4 pt 7 ps 0.5
set linetype 2 lc rgb '#d55e00' lw 2.4 pt 5 ps 0.5
set linetype 3 lc rgb '#009e73' lw 2.4 pt 9 ps 0.6
set linetype 4 lc rgb '#cc79a7' lw 2.4 pt 11 ps 0.6
set linetype 5 lc rgb '#b8860b' lw 2.4 pt 13 ps 0.6
set linetype 6 lc rgb '#000000' lw 2.4 pt 6 ps 0.5
set linetype 7 lc rgb '#56b4e9' lw 2.4 pt 4 ps 0.5
set linetype 8 lc rgb '#e08a00' lw 2.4 pt 8 ps 0.6
set linetype 100 lc rgb '#e3e7ed' lw 1
set border 3 lc rgb '#5b6575'
set tics nomirror textcolor rgb '#1d2430'
set grid back lt 100
set logscale xy
set xrange [1:320000000]
set yrange [10**(-20.40):10**(1.00)]
set xlabel 'events'
set ylabel 'relative energy error' offset 1,0
set lmargin 13
set rmargin 20
unset key
set xtics scale 1,0 ('1' 1, '10^{1}' 1e1, '10^{2}' 1e2, '10^{3}' 1e3, '10^{4}' 1e4, '10^{5}' 1e5, '10^{6}' 1e6, '10^{7}' 1e7, '10^{8}' 1e8)
set ytics ('1' 1, '10^{-4}' 1e-4, '10^{-8}' 1e-8, '10^{-12}' 1e-12, '10^{-16}' 1e-16, 'exactly 0' 10**(-18.45))
set object 1 rectangle from graph 0, graph 0 to graph 1, first 10**(-16.50) behind fillcolor rgb '#f1f4f8' fillstyle solid noborder
set label 1 'logical states' at graph 1, first 10**(-16.10) offset 1,0 tc lt 1
set label 4 '' at 1684, 10**(-1.63) point lt 2 pt 2 ps 1.3 front
set label 3 'state from position: stood still after 1 684 events' at 1684, 10**(-0.64) offset 1.5,0 tc lt 2
set label 6 '' at 1040, 10**(-1.69) point lt 3 pt 2 ps 1.3 front
set label 5 'stored separation: stood still after 1 040 events' at 1040, 10**(-1.69) offset 1.5,0 tc lt 3
set label 7 'nudged time' at graph 1, first 10**(-17.15) offset 1,0 tc lt 4
set label 9 'nudged position' at graph 1, first 10**(-18.20) offset 1,0 tc lt 5
set label 12 '' at 1011, 10**(-19.70) point lt 6 pt 2 ps 1.3 front
set label 11 'algorithm 2 as printed: stood still after 1 011 events' at 1011, 10**(-19.70) offset 1.5,0 tc lt 6
plot NaN, \
    'square-shoulder-algorithm-2-as-printed.dat' using 1:($3 > 0 ? $3 : NaN) with linespoints lt 6 lw 6.2 pt 7 ps 0.69, '' using 1:($3 > 0 ? NaN : 10**(-19.70)) with points lt 6 pt 7 ps 0.3, \
    'square-shoulder-nudged-position.dat' using 1:($3 > 0 ? $3 : NaN) with linespoints lt 5 lw 5.4 pt 7 ps 0.60, '' using 1:($3 > 0 ? NaN : 10**(-18.20)) with points lt 5 pt 7 ps 0.3, \
    'square-shoulder-nudged-time.dat' using 1:($3 > 0 ? $3 : NaN) with linespoints lt 4 lw 4.6 pt 7 ps 0.51, '' using 1:($3 > 0 ? NaN : 10**(-17.80)) with points lt 4 pt 7 ps 0.3, \
    'square-shoulder-stored-separation.dat' using 1:($3 > 0 ? $3 : NaN) with linespoints lt 3 lw 3.8 pt 7 ps 0.42, '' using 1:($3 > 0 ? NaN : 10**(-19.00)) with points lt 3 pt 7 ps 0.3, \
    'square-shoulder-state-from-position.dat' using 1:($3 > 0 ? $3 : NaN) with linespoints lt 2 lw 3.0 pt 7 ps 0.33, '' using 1:($3 > 0 ? NaN : 10**(-18.60)) with points lt 2 pt 7 ps 0.3, \
    'square-shoulder-logical-states.dat' using 1:($3 > 0 ? $3 : NaN) with linespoints lt 1 lw 2.2 pt 7 ps 0.24, '' using 1:($3 > 0 ? NaN : 10**(-17.40)) with points lt 1 pt 7 ps 0.3
