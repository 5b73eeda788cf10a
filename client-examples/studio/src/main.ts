document.querySelector("#studio")?.append("Tuftwave");
