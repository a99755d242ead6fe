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
set xrange [1:320000001]
set format x '10^{%T}'
set format y '10^{%T}'
set xlabel 'events'
set ylabel 'relative energy error' offset 1,0
set lmargin 13
set key left top
plot 'square-shoulder-logical-states.dat' using 1:(abs($5) > 0 ? abs($5) : NaN) with linespoints lt 1 pt 7 ps 0.4 title 'square-shoulder', \
     3.38599e-21 * sqrt(x) lt 2 lw 2 title 'random walk'
