#!/bin/sh
# A study as an array of Slurm: each task computes the part of it that falls to some values of the first key of `vary`.
#
#     sbatch --array=1-16 slurm_array.sh study.yaml results/study
#
# Submitted again, it goes on where it stopped.  When all tasks are over, the parts make up the whole table:
#
#     awk 'NR == 1 || FNR > 1' results/study/part_*/table.csv >results/study/table.csv
#SBATCH --job-name=capsella
#SBATCH --cpus-per-task=4
#SBATCH --time=02:00:00
#SBATCH --signal=B:TERM@60
exec capsella study "$1" -o "$2" --part "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" \
  --jobs "$SLURM_CPUS_PER_TASK" --quiet --resume
