"""What the commands answer: frozen values, each the JSON that its file holds, with a published schema.

One module per kind of answer, loaded when it is asked for; `reader` reads files back, `published` makes the schemas.
Nothing here computes: whatever is worked out of an answer is the same whether it was kept or read again.
"""
