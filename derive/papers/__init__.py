"""What the papers print, held against what `derive` gives: verdicts that nobody types.

A paper's file here holds the printed form of its matrices, closures, ranks and compensators, once, in its own letters,
and the dictionary that takes the letters of `derive` to the paper's. The derived side is never typed: it is the
differential of the same loop closures of which the kernels are made (`letters.differentials`). ``python -m derive
verdicts`` compares them and writes what the ledger of claims reads.
"""
