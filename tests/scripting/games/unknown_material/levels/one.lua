-- The second piece has a slip.
return { pieces = {
    { material = "stone" },
    { material = "wod" },
} }
