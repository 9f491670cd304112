function cairn.load(words) print(table.concat(words, " ")) end
