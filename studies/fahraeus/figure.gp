# gnuplot figure.gp: trends.png from measured.csv, in this folder.
set terminal pngcairo size 860,360 font ",10"
set output "trends.png"
set datafile separator ","
set xlabel "width, or tube diameter [um]"
set xrange [8:42]
set key bottom right
set multiplot layout 1,2
set title "Fahraeus: tube / discharge hematocrit"
set yrange [0.6:0.9]
plot "measured.csv" using 1:5 with points pt 7 title "slit, circular cells, 2D", \
     "" using 1:($2 == 1 ? $13 : NaN) with linespoints pt 6 title "Pries, glass tubes, at our H_D"
set title "Fahraeus-Lindqvist: relative viscosity"
set yrange [1:1.7]
plot "measured.csv" using 1:6 with points pt 7 notitle, \
     "" using 1:($2 == 1 ? $14 : NaN) with linespoints pt 6 notitle
unset multiplot
