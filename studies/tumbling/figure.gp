# gnuplot figure.gp: map.png from measured.csv, in this folder.
set terminal pngcairo size 720,360 font ",10"
set output "map.png"
set datafile separator ","
set logscale y
set xlabel "viscosity ratio"
set ylabel "G"
set xrange [0:21]
set yrange [0.01:1]
set key outside right
swings(k) = column(k + 2) - column(k + 1) > 20
main(k) = column(3) == 0.2 && column(4) == 32
plot "measured.csv" using 1:(main(1) && strcol(5) eq "tank-treads" && !swings(7) ? $2 : NaN) \
         with points pt 7 ps 2 lc rgb "#1f77b4" title "tank-treads", \
     "" using 1:(main(1) && strcol(5) eq "tank-treads" && swings(7) ? $2 : NaN) \
         with points pt 5 ps 2 lc rgb "#ff7f0e" title "swings by > 20 deg", \
     "" using 1:(main(1) && strcol(5) eq "tumbles" ? $2 : NaN) \
         with points pt 6 ps 2 lc rgb "#d62728" title "tumbles", \
     "<echo '2.65,0.01\n2.65,1'" using 1:2 with lines dt 2 lc "gray" title "Keller-Skalak"
