# gnuplot figure.gp: heights.png from heights.csv, in this folder.
set terminal pngcairo size 720,420 font ",10"
set output "heights.png"
set datafile separator ","
set key autotitle columnhead outside right
set xlabel "time [ms]"
set ylabel "height of the cell [um]; the middle is 15"
set yrange [8:15.5]
plot for [k=2:5] "heights.csv" using 1:k with lines dashtype 2 lw 2, \
     for [k=6:8] "heights.csv" using 1:k with lines lw 2, 15 with lines lc "gray" notitle
